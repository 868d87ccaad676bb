// The blocks of a program, drawn as boxes in each other: what is called and what is found stands in the box that it belongs to.
import type { ComponentChildren } from "preact";
import { CodeLine } from "./code";
import type { Blocks, Details } from "./data";
import type { Model } from "./model";
import { severities, signs } from "./model";
import { link } from "./route";
import { level } from "./source";
import { Message } from "./words";

/** One thing in a box. Whatever it is, it has a line, and boxes hold it in the order of their lines. */
interface Thing { line: number; drawn: () => ComponentChildren }

interface Box { title: string; line: number; end: number; known: boolean; scope: boolean; worst: number; boxes: Box[]; things: Thing[] }

function boxesOf(blocks: Blocks, last: number): { all: Box[]; scopes: Box[] } {
  const box = (title: string, line: number, end: number | null, scope: boolean): Box => ({ title, line, end: end ?? last, known: end !== null, scope, worst: -1, boxes: [], things: [] });
  const scopes = blocks.scopes.map(({ title, line, end }) => box(title, line, end, true));
  const all: Box[] = [];
  for (const block of blocks.blocks) {
    const made = box(block.title, block.line, block.end, false);
    const outer = block.parent === null ? scopes[block.scope] : all[block.parent];
    if (block.end === null) made.end = outer.end;
    outer.boxes.push(made);
    all.push(made);
  }
  return { all, scopes };
}

/** The innermost box around a line. */
function innermost(box: Box, line: number): Box {
  const inner = box.boxes.find((b) => b.line <= line && line <= b.end);
  return inner ? innermost(inner, line) : box;
}

export function BlocksView({ model, file, details }: { model: Model; file: number; details: Details & { blocks: Blocks } }) {
  const { blocks, findings } = details;
  const { all, scopes } = boxesOf(blocks, details.lineCount);
  const lines = new Map(details.source.flatMap(([first, texts]) => texts.map((text, i): [number, string] => [first + i, text.trim()])));
  const code = (line: number, title: string) => <code><CodeLine text={lines.get(line)?.slice(0, 120) ?? title} language="program" /></code>;
  const to = (line: number) => link("program", file, { line: String(line) });
  blocks.blocks.forEach((block, i) => {
    for (const part of block.parts) all[i].things.push({ line: part.line, drawn: () => <li class="part"><a href={to(part.line)}>{code(part.line, part.title)} <small>line {part.line}</small></a></li> });
  });
  // Calls of the same sub that follow each other in a box are one entry.
  const calls = new Map<string, number[]>();
  for (const call of blocks.calls) {
    const box = innermost(scopes[call.scope], call.line);
    const key = [call.scope, box.line, call.title].join(" ");
    const known = calls.get(key);
    if (known) { known.push(call.line); continue; }
    const at = [call.line];
    calls.set(key, at);
    const target = call.to;
    const where = target === null ? <span class="nowhere">not found</span>
      : target.file < 0 ? <span>in a file from elsewhere</span>
      : target.file === file ? <a href={to(target.line)}>sub on line {target.line}</a>
      : <a href={link("program", target.file, { line: String(target.line) })}>{model.paths[target.file].slice(model.paths[target.file].lastIndexOf("/") + 1)}</a>;
    box.things.push({ line: call.line, drawn: () => <li class="call"><span aria-hidden="true">→</span> calls <code>{call.title}</code> <small>{at.map((line, i) => <span key={line}>{i > 0 && ", "}<a href={to(line)}>line {line}</a></span>)}</small> · {where}</li> });
  }
  const subs = scopes.slice(1);
  for (const finding of findings) {
    const { line } = finding.start;
    const box = innermost(subs.find((sub) => sub.line <= line && line <= sub.end) ?? scopes[0], line);
    const severity = level(finding);
    box.worst = Math.max(box.worst, severity);
    box.things.push({ line, drawn: () => <li class={`finding ${severities[severity]}`}><a href={to(line)}><span class="sign"><span aria-hidden="true">{signs[severity]}</span> {severities[severity]}</span> line {line}: <Message text={finding.message} /></a></li> });
  }
  const draw = (box: Box): ComponentChildren => {
    const inside = [...box.things, ...box.boxes.map((inner): Thing => ({ line: inner.line, drawn: () => draw(inner) }))].sort((a, b) => a.line - b.line);
    return (
      <li key={`${box.line} ${box.title}`} class={`box${box.scope ? " scope" : ""}${box.worst >= 0 ? ` ${severities[box.worst]}` : ""}`}>
        <a class="head" href={to(box.line)}>{box.scope ? <b>{box.title}</b> : code(box.line, box.title)} <small>{box.known ? `lines ${box.line} to ${box.end}` : box.scope ? `from line ${box.line}` : `line ${box.line}, its end is missing`}</small></a>
        {inside.length > 0 && <ul>{inside.map((thing) => thing.drawn())}</ul>}
      </li>
    );
  };
  const [main] = scopes;
  const drawn = main.things.length + main.boxes.length > 0 || subs.length === 0 ? scopes : subs;
  return <ul class="blocks" aria-label="blocks of the program">{[...drawn].sort((a, b) => a.line - b.line).map(draw)}</ul>;
}
