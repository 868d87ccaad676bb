// All programs, with how many findings each has.
import { useMemo } from "preact/hooks";
import { List } from "./list";
import type { Model } from "./model";
import { number, plural } from "./model";
import { link, replaceQuery, type Route } from "./route";
import { Path } from "./words";

function chosen(model: Model, query: URLSearchParams): number[] {
  const q = (query.get("q") ?? "").toLowerCase();
  const only = query.get("only");
  const [, warnings, errors] = model.counts;
  const { lines, problem } = model.index.files;
  const out: number[] = [];
  for (let f = 0; f < model.shown.length; ++f) {
    if (only === "errors" && errors[f] === 0) continue;
    if (only === "clean" && errors[f] + warnings[f] > 0) continue;
    if (only === "unread" && problem[f] === "") continue;
    if (q !== "" && !model.shown[f].toLowerCase().includes(q)) continue;
    out.push(f);
  }
  if (query.get("sort") === "findings") out.sort((a, b) => errors[b] - errors[a] || warnings[b] - warnings[a] || a - b);
  if (query.get("sort") === "lines") out.sort((a, b) => lines[b] - lines[a] || a - b);
  return out;
}

export function Programs({ model, route }: { model: Model; route: Route }) {
  const query = route.query;
  const rows = useMemo(() => chosen(model, query), [query.toString()]);
  const { lines, problem } = model.index.files;
  const set = (key: string, value: string) => {
    const next = new URLSearchParams(query);
    value ? next.set(key, value) : next.delete(key);
    replaceQuery(next);
  };
  const words = (f: number) => {
    if (problem[f] !== "") return <span class="badge error">cannot be read</span>;
    const [, warnings, errors] = model.counts;
    if (errors[f] + warnings[f] === 0) return <span class="badge fine"><span aria-hidden="true">✓</span> nothing found</span>;
    return <>{errors[f] > 0 && <span class="badge error"><span aria-hidden="true">✕</span> {plural(errors[f], "error")}</span>} {warnings[f] > 0 && <span class="badge warning"><span aria-hidden="true">!</span> {plural(warnings[f], "warning")}</span>}</>;
  };
  return (
    <>
      <h1>Programs</h1>
      <form class="filters" role="search" onSubmit={(e) => e.preventDefault()}>
        <label class="search">Search<input type="search" id="search" value={query.get("q") ?? ""} placeholder="part of a path" onInput={(e) => set("q", e.currentTarget.value)} /></label>
        <label>Show<select aria-label="Show" value={query.get("only") ?? ""} onChange={(e) => set("only", e.currentTarget.value)}><option value="">all</option><option value="errors">with errors</option><option value="clean">with nothing found</option><option value="unread">not readable</option></select></label>
        <label>Sort by<select aria-label="Sort by" value={query.get("sort") ?? ""} onChange={(e) => set("sort", e.currentTarget.value)}><option value="">path</option><option value="findings">findings</option><option value="lines">length</option></select></label>
      </form>
      <p class="found" role="status">{number(rows.length)} of {number(model.shown.length)}</p>
      {rows.length === 0 ? <p class="empty">No program fits.</p> : (
        <List label="programs" count={rows.length} rowHeight={56} href={(n) => link("program", rows[n])}
          row={(n) => <><span class="words"><Path path={model.shown[rows[n]]} /></span><small>{plural(lines[rows[n]], "line")} {words(rows[n])}</small></>} />
      )}
    </>
  );
}
