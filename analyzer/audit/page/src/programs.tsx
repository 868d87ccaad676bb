// All programs, with how many findings each has.
import { useMemo } from "preact/hooks";
import { machine, program } from "./data";
import { Filters } from "./filters";
import { List } from "./list";
import type { Model } from "./model";
import { plural, share } from "./model";
import { link, type Route } from "./route";
import { Path } from "./words";

/** What is shown instead of programs, and what one of them is called. */
const others: Record<string, string> = { machines: "machine INI", outside: "outside sub" };

const isShown = (kind: number, only: string | null) => (only === "machines" ? kind === machine : only === "outside" ? kind > machine : kind === program);

function chosen(model: Model, query: URLSearchParams): number[] {
  const q = (query.get("q") ?? "").toLowerCase();
  const only = query.get("only");
  const sort = query.get("sort");
  const [, warnings, errors] = model.counts;
  const { kind, lines, problem } = model.index.files;
  const out: number[] = [];
  for (let f = 0; f < model.paths.length; ++f) {
    if (!isShown(kind[f], only)) continue;
    if (only === "errors" && errors[f] === 0) continue;
    if (only === "clean" && (errors[f] + warnings[f] > 0 || problem[f] !== "")) continue;
    if (only === "unread" && problem[f] === "") continue;
    if (q !== "" && !model.paths[f].toLowerCase().includes(q)) continue;
    out.push(f);
  }
  if (sort === null) out.sort((a, b) => errors[b] - errors[a] || warnings[b] - warnings[a] || a - b);
  if (sort === "lines") out.sort((a, b) => lines[b] - lines[a] || a - b);
  return out;
}

export function Programs({ model, route }: { model: Model; route: Route }) {
  const query = route.query;
  const rows = useMemo(() => chosen(model, query), [query.toString()]);
  const { kind, lines, problem } = model.index.files;
  const only = query.get("only");
  const all = kind.reduce((n, k) => n + (isShown(k, only) ? 1 : 0), 0);
  const has = (other: string) => kind.some((k) => isShown(k, other));
  const words = (f: number) => {
    if (problem[f] !== "") return <span class="badge error">cannot be read</span>;
    const [, warnings, errors] = model.counts;
    if (errors[f] + warnings[f] === 0) return <span class="badge fine"><span aria-hidden="true">✓</span> nothing found</span>;
    return <>{errors[f] > 0 && <span class="badge error"><span aria-hidden="true">✕</span> {plural(errors[f], "error")}</span>} {warnings[f] > 0 && <span class="badge warning"><span aria-hidden="true">!</span> {plural(warnings[f], "warning")}</span>}</>;
  };
  const selects = [
    { name: "Show", key: "only", choices: [["", "all programs"], ["errors", "with errors"], ["clean", "with nothing found"], ["unread", "not readable"],
      ...(has("machines") ? [["machines", "machine INIs"]] : []), ...(has("outside") ? [["outside", "outside subs"]] : [])] as [string, string][] },
    { name: "Sort by", key: "sort", choices: [["", "findings"], ["path", "path"], ["lines", "length"]] as [string, string][] },
  ];
  return (
    <>
      <h1>Programs</h1>
      <Filters query={query} placeholder="part of a path" selects={selects} />
      <p class="found" role="status">{share(rows.length, all, others[only ?? ""] ?? "program")}</p>
      {rows.length === 0 ? <p class="empty">No program fits.</p> : (
        <List label="programs" count={rows.length} rowHeight={60} href={(n) => link("program", rows[n])}
          row={(n) => <><span class="place"><Path path={model.paths[rows[n]]} /></span><small class="about">{words(rows[n])} <span class="lines">{plural(lines[rows[n]], "line")}</span></small></>} />
      )}
    </>
  );
}
