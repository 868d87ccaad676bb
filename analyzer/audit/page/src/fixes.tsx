// What the fixes of a finding change: the lines as they are, and as they would be.
import { CodeLine } from "./code";
import type { Details, Edit, Fix, Position } from "./data";
import type { Language } from "./highlight";
import { plural } from "./model";
import { Message } from "./words";

interface Change { line: number; before: string[]; after: string[] }

/** Makes the edits in some lines that follow each other; `first` is the number of the first one. */
function edited(lines: string[], first: number, edits: Edit[]): string[] {
  const starts: number[] = [];
  const points = lines.flatMap((line, i) => {
    starts.push(i === 0 ? 0 : starts[i - 1] + [...lines[i - 1]].length + 1);
    return [...line, ...(i + 1 < lines.length ? ["\n"] : [])];
  });
  const offset = ({ line, column }: Position) => Math.min(starts[line - first] + column - 1, points.length);
  for (const edit of [...edits].reverse()) points.splice(offset(edit.start), offset(edit.end) - offset(edit.start), ...edit.text);
  return points.join("").split("\n");
}

/** The changed lines, a piece for all edits that touch the same lines; null where this page does not have the lines. */
export function changes(details: Details, fix: Fix): Change[] | null {
  const text = (line: number) => {
    const stretch = details.source.find(([first, texts]) => first <= line && line < first + texts.length);
    return stretch?.[1][line - stretch[0]];
  };
  const edits = [...fix.edits].sort((a, b) => a.start.offset - b.start.offset);
  const out: Change[] = [];
  for (let at = 0; at < edits.length; ) {
    const first = edits[at].start.line;
    let last = edits[at].end.line;
    const group: Edit[] = [];
    for (; at < edits.length && edits[at].start.line <= last; ++at) {
      group.push(edits[at]);
      last = Math.max(last, edits[at].end.line);
    }
    const before: string[] = [];
    for (let line = first; line <= last; ++line) {
      const found = text(line) ?? (line === details.lineCount + 1 ? "" : undefined);  // an edit may end behind the last line
      if (found === undefined) return null;
      before.push(found);
    }
    const after = edited(before, first, group);
    let line = first;
    while (before.length > 0 && after.length > 0 && before[0] === after[0]) { before.shift(); after.shift(); ++line; }
    while (before.length > 0 && after.length > 0 && before[before.length - 1] === after[after.length - 1]) { before.pop(); after.pop(); }
    if (before.length + after.length > 0) out.push({ line, before, after });
  }
  return out;
}

export function Fixes({ details, fixes, language }: { details: Details; fixes: Fix[]; language: Language }) {
  const most = 4;  // places that are shown
  return (
    <>{fixes.map((fix, i) => {
      const made = changes(details, fix) ?? [];
      return (
        <div key={i} class="fix">
          <p><b>{fix.safe ? "Safe fix" : "Possible fix"}</b> <Message text={fix.title} />; {fix.safe ? <><code>owlint check --fix</code> makes it</> : <>look at it first: <code>owlint check --fix --unsafe</code> makes it</>}</p>
          {made.length > 0 && <pre tabIndex={0} aria-label="what the fix changes">{made.slice(0, most).map((change, k) => (
            <span key={k}>
              {change.before.map((line, n) => <del key={`b${n}`}><span class="number">{change.line + n}</span><span class="sign">−</span><CodeLine text={line} language={language} />{"\n"}</del>)}
              {change.after.map((line, n) => <ins key={`a${n}`}><span class="number">{change.line + n}</span><span class="sign">+</span><CodeLine text={line} language={language} />{"\n"}</ins>)}
            </span>
          ))}</pre>}
          {made.length > most && <p>and in {plural(made.length - most, "more place")}</p>}
        </div>
      );
    })}</>
  );
}
