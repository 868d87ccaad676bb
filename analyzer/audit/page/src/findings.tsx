// All findings: searched, filtered, sorted.
import { useMemo } from "preact/hooks";
import { List } from "./list";
import type { Model } from "./model";
import { number, severities } from "./model";
import { link, replaceQuery, type Route } from "./route";
import { Badge, Message, Path } from "./words";

const printed = 500;

export function chosen(model: Model, query: URLSearchParams): number[] {
  const { file, rule, severity, message, isNew, line } = model.index.findings;
  const q = (query.get("q") ?? "").toLowerCase();
  const wantedSeverity = query.get("severity");
  const wantedRule = query.get("rule");
  const wantedState = query.get("state");
  const folder = query.get("folder") ?? "";
  const ruleNumber = model.index.rules.findIndex((r) => r.code === wantedRule);
  const inRule = model.index.rules.map((r) => q !== "" && `${r.code} ${r.name}`.toLowerCase().includes(q));
  const inPath = new Map<number, boolean>();
  const pathFits = (f: number) => {
    let fits = inPath.get(f);
    if (fits === undefined) inPath.set(f, (fits = model.shown[f].toLowerCase().includes(q)));
    return fits;
  };
  const out: number[] = [];
  for (let i = 0; i < file.length; ++i) {
    if (wantedSeverity !== null && severity[i] !== Number(wantedSeverity)) continue;
    if (wantedRule !== null && rule[i] !== ruleNumber) continue;
    if (wantedState !== null && (isNew[i] === 1) !== (wantedState === "new")) continue;
    if (folder !== "" && !model.shown[file[i]].startsWith(folder)) continue;
    if (q !== "" && !inRule[rule[i]] && !pathFits(file[i]) && !message[i].toLowerCase().includes(q)) continue;
    out.push(i);
  }
  const codes = model.index.rules.map((r) => r.code);
  if (query.get("sort") === "severity") out.sort((a, b) => severity[b] - severity[a] || file[a] - file[b] || line[a] - line[b]);
  if (query.get("sort") === "rule") out.sort((a, b) => (codes[rule[a]] < codes[rule[b]] ? -1 : codes[rule[a]] > codes[rule[b]] ? 1 : file[a] - file[b]));
  return out;
}

export function Findings({ model, route }: { model: Model; route: Route }) {
  const query = route.query;
  const rows = useMemo(() => chosen(model, query), [query.toString()]);
  const { findings, rules } = model.index;
  const set = (key: string, value: string) => {
    const next = new URLSearchParams(query);
    value ? next.set(key, value) : next.delete(key);
    replaceQuery(next);
  };
  const select = (name: string, key: string, choices: [string, string][]) => (
    <label>{name}<select aria-label={name} value={query.get(key) ?? ""} onChange={(e) => set(key, e.currentTarget.value)}>{choices.map(([value, words]) => <option key={value} value={value}>{words}</option>)}</select></label>
  );
  const place = (i: number) => <small><Path path={model.shown[findings.file[i]]} />:{findings.line[i]} · {rules[findings.rule[i]].code} {rules[findings.rule[i]].name}{findings.isNew[i] === 1 && <b class="new">new</b>}</small>;
  return (
    <>
      <h1>Findings</h1>
      <form class="filters" role="search" onSubmit={(e) => e.preventDefault()}>
        <label class="search">Search<input type="search" id="search" value={query.get("q") ?? ""} placeholder="words, path or rule" onInput={(e) => set("q", e.currentTarget.value)} /></label>
        {select("Severity", "severity", [["", "all"], ...[2, 1, 0].map((s): [string, string] => [String(s), `${severities[s]}s`])])}
        {select("Rule", "rule", [["", "all"], ...model.byRule().map(({ rule }): [string, string] => [rules[rule].code, `${rules[rule].code} ${rules[rule].name}`])])}
        {model.before && select("State", "state", [["", "all"], ["new", "new"], ["old", "known before"]])}
        {select("Sort by", "sort", [["", "program"], ["severity", "severity"], ["rule", "rule"]])}
        {query.get("folder") && <button type="button" onClick={() => set("folder", "")}>in <Path path={query.get("folder")!} /> ✕</button>}
      </form>
      <p class="found" role="status">{number(rows.length)} of {number(findings.file.length)}</p>
      {rows.length === 0 ? <p class="empty">No finding fits.</p> : (
        <List label="findings" count={rows.length} rowHeight={68} href={(n) => link("program", findings.file[rows[n]], { line: String(findings.line[rows[n]]) })}
          row={(n) => <><Badge severity={findings.severity[rows[n]]} /><span class="words"><Message text={findings.message[rows[n]]} /></span>{place(rows[n])}</>} />
      )}
      <ul class="plain print-only">{rows.slice(0, printed).map((i) => <li key={i}><Badge severity={findings.severity[i]} /> <span><Message text={findings.message[i]} /></span>{place(i)}</li>)}
        {rows.length > printed && <li>{number(rows.length - printed)} more are left out here.</li>}</ul>
    </>
  );
}
