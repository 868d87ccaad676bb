// Small pieces of text that appear everywhere.
import type { ComponentChildren } from "preact";
import { severities, signs } from "./model";

// What would turn the reading direction round, or be invisible, is shown as what it is.
const unseen = /[\u0000-\u001f\u007f-\u009f\u200b-\u200f\u202a-\u202e\u2066-\u2069\ufeff]/g;

export function visible(text: string): string {
  return text.replace(/\n/g, "⏎").replace(/\t/g, "⇥").replace(unseen, (c) => `⟨${c.codePointAt(0)!.toString(16).padStart(4, "0")}⟩`);
}

/** Text with `code` in backticks. */
export function Message({ text }: { text: string }) {
  const parts = visible(text).split("`");
  return <>{parts.map((part, i) => (i % 2 === 1 && i < parts.length - 1 ? <code key={i}>{part}</code> : i % 2 === 1 ? "`" + part : part))}</>;
}

const split = (path: string) => [path.slice(0, path.lastIndexOf("/") + 1), path.slice(path.lastIndexOf("/") + 1)];

/** A path on a line of its own, with a line number perhaps. Its front is cut where it does not fit: the end tells files apart. */
export function Path({ path, line }: { path: string; line?: number }) {
  const text = visible(path);
  const [folder, name] = split(text);
  return <span class="path cut" title={text.slice(-4000)}><bdi><span class="folder">{folder}</span>{name}{line === undefined ? "" : `:${line}`}</bdi></span>;
}

/** A path in running text, all of it; it is broken behind its slashes. Of a very long one the middle is left out. */
export function WholePath({ path }: { path: string }) {
  const text = visible(path);
  const [folder, name] = split(text.length > 160 ? `${text.slice(0, 70)} … ${text.slice(-80)}` : text);
  return <span class="path" title={text.length > 160 ? text.slice(0, 4000) : undefined}><span class="folder">{folder.split(/(?<=\/)/).map((part, i) => <span key={i}>{part}<wbr /></span>)}</span>{name}</span>;
}

export function Badge({ severity }: { severity: number }) {
  return <span class={`badge ${severities[severity]}`}><span aria-hidden="true">{signs[severity]}</span> <span class="word">{severities[severity]}</span></span>;
}

export function Count({ n, kind }: { n: number; kind: string }) {
  return <span class={n > 0 ? `count ${kind}` : "count none"}>{n.toLocaleString("en")}</span>;
}

export function Panel({ title, children, extra }: { title: string; children: ComponentChildren; extra?: ComponentChildren }) {
  return <section class="panel"><header><h2>{title}</h2>{extra}</header>{children}</section>;
}
