// A program's lines with its findings in place.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Details, Finding } from "./data";
import type { Model } from "./model";
import { number, severities } from "./model";
import { link } from "./route";
import { Badge, Message, Path, visible } from "./words";

const level = (finding: Finding) => severities.indexOf(finding.severity as (typeof severities)[number]);

/** A line's text, with the ranges that findings are about underlined. Columns count code points from 1. */
function Text({ text, number: line, findings }: { text: string; number: number; findings: Finding[] }) {
  const points = [...text];
  const marks = new Array<number>(points.length + 1).fill(-1);
  for (const f of findings) {
    const end = f.end.line > line ? points.length + 1 : Math.max(f.end.column, f.start.column + 1);
    for (let column = f.start.column; column < end && column <= points.length + 1; ++column) marks[column - 1] = Math.max(marks[column - 1], level(f));
  }
  const out: ComponentChildren[] = [];
  for (let at = 0; at < points.length; ) {
    let end = at;
    while (end < points.length && marks[end] === marks[at]) ++end;
    const words = points.slice(at, end).map((c) => (c === "\t" ? "\t" : visible(c))).join("");
    out.push(marks[at] < 0 ? words : <mark key={at} class={severities[marks[at]]}>{words}</mark>);
    at = end;
  }
  return <>{out}</>;
}

function Told({ model, file, finding, open }: { model: Model; file: number; finding: Finding; open: (code: string) => void }) {
  return (
    <div class={`told ${finding.severity}`}>
      <p><Badge severity={level(finding)} /> <Message text={finding.message} /> <button type="button" class="code" onClick={() => open(finding.code)}>{finding.code} {finding.rule}</button></p>
      {finding.related.map((r, i) => {
        const target = r.path === model.index.files.path[file] ? file : model.fileOf(r.path);
        const place = target === file ? `line ${r.start.line}` : <><Path path={r.path} />:{r.start.line}</>;
        return <p key={i} class="more">{target === undefined ? place : <a href={link("program", target, { line: String(r.start.line) })}>{place}</a>}: <Message text={r.message} /></p>;
      })}
      {finding.interpreter && <p class="more"><b>LinuxCNC says</b> {visible(finding.interpreter)}</p>}
      {finding.help && <p class="more"><b>Fix</b> <Message text={finding.help} /></p>}
      {finding.reach === "never" && <p class="more">No run gets here as the program stands.</p>}
    </div>
  );
}

interface Props { model: Model; file: number; details: Details; line: number; open: (code: string) => void }

export function SourceView({ model, file, details, line, open }: Props) {
  const list = useRef<HTMLOListElement>(null);
  const byLine = new Map<number, Finding[]>();
  for (const f of details.findings) byLine.get(f.start.line)?.push(f) ?? byLine.set(f.start.line, [f]);
  useEffect(() => {
    const target = list.current?.querySelector<HTMLElement>(`[data-line="${line}"]`);
    if (line === 0 || !target) return;
    target.focus({ preventScroll: true });
    target.scrollIntoView({ block: "nearest" });
  }, [line, details]);
  const rows: ComponentChildren[] = [];
  let next = 1;
  const gap = (from: number, to: number) => {
    if (to > from) rows.push(<li key={`gap${from}`} class="gap">{number(to - from)} lines are left out here</li>);
  };
  for (const [first, texts] of details.source) {
    gap(next, first);
    texts.forEach((text, i) => {
      const n = first + i;
      const found = byLine.get(n) ?? [];
      rows.push(
        <li key={n} data-line={n} tabIndex={-1} class={n === line ? "chosen" : undefined}>
          <span class="number">{n}</span><code><Text text={text} number={n} findings={found} /></code>
          {found.map((f, k) => <Told key={k} model={model} file={file} finding={f} open={open} />)}
        </li>,
      );
    });
    next = first + texts.length;
  }
  gap(next, details.lineCount + 1);
  return <ol class="source" aria-label="program" ref={list}>{rows}</ol>;
}
