// The first view: how many programs have errors, how it went from run to run, and where to look first.
import { machine } from "./data";
import type { Model } from "./model";
import { number, plural } from "./model";
import { link } from "./route";
import { Trend } from "./trend";
import { Badge, Count, Message, Panel, Path, WholePath } from "./words";

function Totals({ model }: { model: Model }) {
  const { run, before, counts } = model;
  const failing = counts[2].reduce((n, errors, file) => n + (errors > 0 && model.isProgram(file) ? 1 : 0), 0);
  const change = (now: number, then: number | undefined) => {
    if (then === undefined || now === then) return null;
    return <span class={now > then ? "worse" : "better"}>{now > then ? "▲" : "▼"} {number(Math.abs(now - then))} since run {before!.id}</span>;
  };
  return (
    <ul class="totals">
      <li class={failing > 0 ? "bad" : "good"}><a href={link("programs", "", { only: "errors" })}><strong>{number(failing)}</strong> {failing === 1 ? "program has" : "programs have"} errors</a><span>of {plural(model.programs, "program")}</span></li>
      <li><a href={link("findings", "", { severity: "2" })}><strong>{number(run.errors)}</strong> {run.errors === 1 ? "error" : "errors"}</a>{change(run.errors, before?.errors)}</li>
      <li><a href={link("findings", "", { severity: "1" })}><strong>{number(run.warnings)}</strong> {run.warnings === 1 ? "warning" : "warnings"}</a>{change(run.warnings, before?.warnings)}</li>
      {before && <li><a href={link("findings", "", { state: "new" })}><strong>{number(run.new)}</strong> new</a><span>{number(run.gone)} gone since run {before.id}</span></li>}
    </ul>
  );
}

function Rules({ model }: { model: Model }) {
  const rows = model.byRule();
  if (rows.length === 0) return <p class="empty">Nothing was found.</p>;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="findings by rule">
      <table class="wide">
        <thead><tr><th scope="col">rule</th><th scope="col">errors</th><th scope="col">warnings</th></tr></thead>
        <tbody>{rows.map(({ rule, counts }) => {
          const { code, name, summary } = model.index.rules[rule];
          return (
            <tr key={code}>
              <th scope="row"><a href={link("findings", "", { rule: code })}><span class="code">{code}</span> {name}</a><span class="about"><Message text={summary} /></span></th>
              <td><Count n={counts[2]} kind="error" /></td><td><Count n={counts[1]} kind="warning" /></td>
            </tr>
          );
        })}</tbody>
      </table>
    </div>
  );
}

function Folders({ model, below }: { model: Model; below: string }) {
  const most = 200;
  const all = model.folders(below);
  const rows = all.slice(0, most);
  const steps = below.split("/").filter(Boolean);
  const machines = model.index.files.kind.filter((kind) => kind === machine).length;
  const name = (path: string) => (path === "" ? "programs right here" : path === "…/" ? "outside of the audited folders" : path.slice(below.length));
  return (
    <>
      <nav class="steps" aria-label="folder"><a href={link("")}>all</a>{steps.map((step, i) => <span key={i}> / <a href={link("", "", { folder: `${steps.slice(0, i + 1).join("/")}/` })}><WholePath path={step} /></a></span>)}</nav>
      <div class="scroll" tabIndex={0} role="region" aria-label="findings by folder">
        <table class="wide">
          <thead><tr><th scope="col">folder</th><th scope="col">programs</th><th scope="col">errors</th><th scope="col">warnings</th></tr></thead>
          <tbody>{rows.map((row) => (
            <tr key={row.path}>
              <th scope="row"><a href={row.path === "" ? link("programs", "", { q: below }) : link("", "", { folder: row.path })}><WholePath path={name(row.path)} /></a></th>
              <td>{number(row.programs)}</td><td><Count n={row.errors} kind="error" /></td><td><Count n={row.warnings} kind="warning" /></td>
            </tr>
          ))}</tbody>
        </table>
      </div>
      {all.length > most && <p class="about">{plural(all.length - most, "more folder")}, with fewer findings, {all.length - most === 1 ? "is" : "are"} left out here.</p>}
      {below === "" && machines > 0 && <p class="about">Not counted as programs: <a href={link("programs", "", { only: "machines" })}>{plural(machines, "machine INI")} with findings</a>.</p>}
    </>
  );
}

function News({ model }: { model: Model }) {
  const { findings, gone, rules } = model.index;
  if (!model.before) return <p class="empty">This is the first run. After the next one, this panel shows what is new and what is gone.</p>;
  const fresh = model.worstFirst([...findings.isNew.keys()].filter((i) => findings.isNew[i] === 1)).slice(0, 8);
  const about = (path: string, line: number, rule: number) => <><small><Path path={path} line={line} /></small><small>{rules[rule].code} {rules[rule].name}</small></>;
  return (
    <>
      {fresh.length === 0 && gone.path.length === 0 && <p class="empty">Nothing has changed since run {model.before.id}.</p>}
      {fresh.length > 0 && <ul class="plain">{fresh.map((i) => (
        <li key={i}><a href={link("program", findings.file[i], { line: String(findings.line[i]) })}><Badge severity={findings.severity[i]} /> <span><Message text={findings.message[i]} /></span>{about(model.paths[findings.file[i]], findings.line[i], findings.rule[i])}</a></li>
      ))}</ul>}
      {model.run.new > fresh.length && <p><a href={link("findings", "", { state: "new" })}>All {number(model.run.new)} new findings</a></p>}
      {gone.path.length > 0 && <details><summary>{plural(gone.path.length, "finding")} gone</summary>
        <ul class="plain gone">{gone.path.slice(0, 200).map((path, i) => <li key={i}><span><Message text={gone.message[i]} /></span>{about(path, gone.line[i], gone.rule[i])}</li>)}</ul>
        {gone.path.length > 200 && <p>and {number(gone.path.length - 200)} more</p>}</details>}
    </>
  );
}

export function Overview({ model, folder }: { model: Model; folder: string }) {
  const { run, index: { roots } } = model;
  const named = roots.slice(0, 3);
  return (
    <>
      <h1>{named.map((root, i) => <span key={i}>{i > 0 && ", "}<WholePath path={root} /></span>)}{roots.length > named.length && ` and ${number(roots.length - named.length)} more`}</h1>
      <p class="when">Run {run.id}, {run.started.replace("T", " ").replace("Z", " UTC")}: {plural(model.programs, "program")}, {run.checked === model.programs ? "all" : number(run.checked)} analysed anew.</p>
      <Totals model={model} />
      <div class="columns">
        <div><Panel title="From run to run"><Trend runs={model.index.runs} /></Panel><Panel title="By rule"><Rules model={model} /></Panel></div>
        <div><Panel title="New and gone"><News model={model} /></Panel><Panel title="By folder"><Folders model={model} below={folder} /></Panel></div>
      </div>
    </>
  );
}
