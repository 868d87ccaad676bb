// Lines of code with their colours, and with marks under what findings are about.
import type { ComponentChildren } from "preact";
import { pieces, type Language } from "./highlight";
import { severities } from "./model";
import { visible } from "./words";

/** From one column to before another one; columns count code points from 1. */
export interface Mark { from: number; to: number; severity: number }

const shown = (text: string) => [...text].map((c) => (c === "\t" ? "\t" : visible(c))).join("");

export function CodeLine({ text, language, marks = [] }: { text: string; language: Language; marks?: Mark[] }) {
  const points = [...text];
  const levels = new Array<number>(Math.max(points.length, ...marks.map((mark) => mark.to - 1))).fill(-1);
  for (const { from, to, severity } of marks) {
    for (let column = from; column < to; ++column) levels[column - 1] = Math.max(levels[column - 1], severity);
  }
  const kinds = pieces(text, language).flatMap(({ text: piece, kind }) => [...piece].map(() => kind));
  const out: ComponentChildren[] = [];
  for (let at = 0; at < levels.length; ) {
    let end = at;
    const inside: ComponentChildren[] = [];
    while (end < levels.length && levels[end] === levels[at]) {
      const begin = end;
      while (end < levels.length && levels[end] === levels[at] && kinds[end] === kinds[begin]) ++end;
      const words = shown(points.slice(begin, end).join(""));
      inside.push(kinds[begin] ? <span key={begin} class={`tok-${kinds[begin]}`}>{words}</span> : words);
    }
    out.push(levels[at] < 0 ? inside : <mark key={at} class={severities[levels[at]]}>{inside}</mark>);
    at = end;
  }
  return <>{out}</>;
}

export function CodeLines({ text, language }: { text: string; language: Language }) {
  return <>{text.split("\n").map((line, i) => <span key={i}>{i > 0 && "\n"}<CodeLine text={line} language={language} /></span>)}</>;
}
