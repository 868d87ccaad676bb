// All findings: searched, filtered, sorted.
import { useMemo } from "preact/hooks";
import { choose, Filters } from "./filters";
import { List } from "./list";
import type { Model } from "./model";
import { number, severities, share } from "./model";
import { useNarrow } from "./narrow";
import { link, type Route } from "./route";
import { Badge, Message, Path, WholePath } from "./words";

const printed = 500;

export function chosen(model: Model, query: URLSearchParams): number[] {
  const { file, rule, severity, message, isNew, fix } = model.index.findings;
  const q = (query.get("q") ?? "").toLowerCase();
  const wantedSeverity = query.get("severity");
  const wantedRule = query.get("rule");
  const wantedState = query.get("state");
  const wantedFix = query.get("fix");
  const folder = query.get("folder") ?? "";
  const ruleNumber = model.index.rules.findIndex((r) => r.code === wantedRule);
  const inRule = model.index.rules.map((r) => q !== "" && `${r.code} ${r.name}`.toLowerCase().includes(q));
  const inPath = new Map<number, boolean>();
  const pathFits = (f: number) => {
    let fits = inPath.get(f);
    if (fits === undefined) inPath.set(f, (fits = model.paths[f].toLowerCase().includes(q)));
    return fits;
  };
  const out: number[] = [];
  for (let i = 0; i < file.length; ++i) {
    if (wantedSeverity !== null && severity[i] !== Number(wantedSeverity)) continue;
    if (wantedRule !== null && rule[i] !== ruleNumber) continue;
    if (wantedState !== null && (isNew[i] === 1) !== (wantedState === "new")) continue;
    if (wantedFix !== null && fix[i] !== Number(wantedFix)) continue;
    if (folder !== "" && !model.paths[file[i]].startsWith(folder)) continue;
    if (q !== "" && !inRule[rule[i]] && !pathFits(file[i]) && !message[i].toLowerCase().includes(q)) continue;
    out.push(i);
  }
  const codes = model.index.rules.map((r) => r.code);
  const sort = query.get("sort");
  if (sort === "path") return out;  // as the index has them
  if (sort === "rule") return out.sort((a, b) => (codes[rule[a]] < codes[rule[b]] ? -1 : codes[rule[a]] > codes[rule[b]] ? 1 : a - b));
  return model.worstFirst(out);
}

const fixes = ["", "fix", "safe fix"] as const;

export function Findings({ model, route }: { model: Model; route: Route }) {
  const query = route.query;
  const narrow = useNarrow();
  const rows = useMemo(() => chosen(model, query), [query.toString()]);
  const { findings, rules } = model.index;
  const selects = [
    { name: "Severity", key: "severity", choices: [["", "all"], ...[2, 1, 0].map((s) => [String(s), `${severities[s]}s`])] as [string, string][] },
    { name: "Rule", key: "rule", choices: [["", "all"], ...model.byRule().map(({ rule }) => [rules[rule].code, `${rules[rule].code} ${rules[rule].name}`])] as [string, string][] },
    ...(model.before ? [{ name: "State", key: "state", choices: [["", "all"], ["new", "new"], ["old", "known before"]] as [string, string][] }] : []),
    { name: "Fix", key: "fix", choices: [["", "all"], ["2", "with a safe fix"], ["1", "with another fix"], ["0", "without a fix"]] as [string, string][] },
    { name: "Sort by", key: "sort", choices: [["", "severity"], ["path", "path"], ["rule", "rule"]] as [string, string][] },
  ];
  const about = (i: number) => <small class="about">{findings.isNew[i] === 1 && <b class="new">new </b>}{findings.fix[i] > 0 && <b class="fix">{fixes[findings.fix[i]]} </b>}{rules[findings.rule[i]].code} {rules[findings.rule[i]].name}</small>;
  const place = (i: number) => <small class="place"><Path path={model.paths[findings.file[i]]} line={findings.line[i]} /></small>;
  return (
    <>
      <h1>Findings</h1>
      <Filters query={query} placeholder="words, path or rule" selects={selects}
        extra={query.get("folder") && <button type="button" onClick={() => choose(query, "folder", "")}>in <WholePath path={query.get("folder")!} /> ✕</button>} />
      <p class="found" role="status">{share(rows.length, findings.file.length, "finding")}</p>
      {rows.length === 0 ? <p class="empty">No finding fits.</p> : (
        <List label="findings" count={rows.length} rowHeight={narrow ? 108 : 68} href={(n) => link("program", findings.file[rows[n]], { line: String(findings.line[rows[n]]) })}
          row={(n) => <><Badge severity={findings.severity[rows[n]]} />{about(rows[n])}<span class="words"><Message text={findings.message[rows[n]]} /></span>{place(rows[n])}</>} />
      )}
      <ul class="plain print-only">{rows.slice(0, printed).map((i) => <li key={i}><Badge severity={findings.severity[i]} /> <span><Message text={findings.message[i]} /></span>{place(i)}{about(i)}</li>)}
        {rows.length > printed && <li>{number(rows.length - printed)} more are left out here.</li>}</ul>
    </>
  );
}
