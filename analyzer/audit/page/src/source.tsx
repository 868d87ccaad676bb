// A program's lines with its findings in place.
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { CodeLine, type Mark } from "./code";
import type { Details, Finding } from "./data";
import { Fixes } from "./fixes";
import type { Language } from "./highlight";
import { number, severities } from "./model";
import { ModesPanel, notesOf } from "./modes";
import { useNarrow } from "./narrow";
import { link } from "./route";
import { Badge, Message, visible, WholePath } from "./words";

export const level = (finding: Finding) => severities.indexOf(finding.severity as (typeof severities)[number]);

/** What of a line the findings on it are about. */
const marksOf = (findings: Finding[], line: number, text: string): Mark[] => findings.map((f) => ({
  from: f.start.column,
  to: f.end.line > line ? [...text].length + 1 : Math.max(f.end.column, f.start.column + 1),
  severity: level(f),
}));

interface Props { file: number; details: Details; language: Language; line: number; open: (event: MouseEvent, code: string) => void }

function Report({ file, details, language, finding, open }: Omit<Props, "line"> & { finding: Finding }) {
  return (
    <div class={`report ${finding.severity}`}>
      <p><Badge severity={level(finding)} /> <Message text={finding.message} /> <a class="rule-link" href={link("rule", finding.code)} onClick={(event) => open(event, finding.code)}>{finding.code} {finding.rule}</a></p>
      {finding.related.map((r, i) => {
        const place = r.file === file ? `line ${r.start.line}` : <><WholePath path={r.path} />:{r.start.line}</>;
        return <p key={i} class="more">{finding.reach === "never" && i === finding.pathFrom && <b>Not reached </b>}{r.file < 0 ? place : <a href={link("program", r.file, { line: String(r.start.line) })}>{place}</a>}: <Message text={r.message} /></p>;
      })}
      {finding.interpreter && <p class="more"><b>LinuxCNC says</b> <q>{visible(finding.interpreter)}</q></p>}
      {finding.help && <p class="more"><b>Fix</b> <Message text={finding.help} /></p>}
      {finding.arc && <img class="arc" src={`data:image/svg+xml,${encodeURIComponent(finding.arc.drawing)}`} alt={finding.arc.words} />}
      <Fixes details={details} fixes={finding.fixes} language={language} />
    </div>
  );
}

export function SourceView(props: Props) {
  const { file, details, language, line } = props;
  const list = useRef<HTMLOListElement>(null);
  const narrow = useNarrow();
  const notes = useMemo(() => (details.modes ? notesOf(details.modes) : new Map<number, string[]>()), [details]);
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
    if (to > from) rows.push(<li key={`gap${from}`} class="gap">{to - from === 1 ? "1 line is" : `${number(to - from)} lines are`} left out here</li>);
  };
  for (const [first, texts] of details.source) {
    gap(next, first);
    texts.forEach((text, i) => {
      const n = first + i;
      const found = byLine.get(n) ?? [];
      rows.push(
        <li key={n} data-line={n} tabIndex={-1} class={n === line ? "chosen" : undefined}>
          <a class="number" href={link("program", file, { line: String(n) })} tabIndex={-1} aria-label={`line ${n}`}>{n}</a><code><CodeLine text={text} language={language} marks={marksOf(found, n, text)} /></code>
          {notes.has(n) && <span class="note" title="in effect from here on">{notes.get(n)!.join(", ")}</span>}
          {found.map((f, k) => <Report key={k} {...props} finding={f} />)}
          {narrow && n === line && details.modes && <ModesPanel file={file} modes={details.modes} line={line} />}
        </li>,
      );
    });
    next = first + texts.length;
  }
  gap(next, details.lineCount + 1);
  // The arrow keys lead from line to line, and into the lines.
  const step = (event: KeyboardEvent) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key] ?? 0;
    if (by === 0 || !(event.target as Element).matches(".source, [data-line]")) return;
    const next = list.current?.querySelector<HTMLElement>(line === 0 ? "[data-line]" : `[data-line="${line + by}"]`);
    if (!next) return;
    event.preventDefault();
    location.hash = link("program", file, { line: next.dataset.line });
  };
  return <ol class="source" aria-label="program" tabIndex={0} ref={list} onKeyDown={step}>{rows}</ol>;
}
