// How errors and warnings went from run to run: a drawing each, because there are few errors where there are many warnings, and
// the same as a table for those who do not see them.
import type { Run } from "./data";
import { number } from "./model";

const width = 320, height = 144, left = 44, right = 14, top = 36, bottom = 26;

function Line({ runs, of }: { runs: Run[]; of: "errors" | "warnings" }) {
  const most = Math.max(1, ...runs.map((run) => run[of]));
  const last = runs[runs.length - 1];
  const x = (i: number) => (runs.length < 2 ? (left + width - right) / 2 : left + (i * (width - left - right)) / (runs.length - 1));
  const y = (n: number) => top + (height - top - bottom) * (1 - n / most);
  return (
    <svg class={`trend ${of}`} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`${of} in the last ${runs.length} runs, now ${number(last[of])}; the table below has the numbers`}>
      <text class="title" x={0} y={13}>{of}</text>
      {[0, most].map((n) => (
        <g key={n}><line class="grid" x1={left} x2={width} y1={y(n)} y2={y(n)} /><text x={left - 8} y={y(n) + 4} text-anchor="end">{number(n)}</text></g>
      ))}
      <polyline points={runs.map((run, i) => `${x(i)},${y(run[of])}`).join(" ")} />
      {runs.map((run, i) => <circle key={run.id} cx={x(i)} cy={y(run[of])} r={runs.length > 30 ? 2 : 3.5}><title>{`run ${run.id}: ${number(run[of])} ${of}`}</title></circle>)}
      <text x={x(0)} y={height - 6} text-anchor={runs.length < 2 ? "middle" : "start"}>run {runs[0].id}</text>
      {runs.length > 1 && <text x={x(runs.length - 1)} y={height - 6} text-anchor="end">run {last.id}</text>}
    </svg>
  );
}

export function Trend({ runs }: { runs: Run[] }) {
  const shown = runs.slice(-60);
  return (
    <>
      <div class="trends"><Line runs={shown} of="errors" /><Line runs={shown} of="warnings" /></div>
      <details>
        <summary>All runs as a table</summary>
        <div class="scroll" tabIndex={0} role="region" aria-label="all runs">
          <table>
            <thead><tr><th scope="col">run</th><th scope="col">started (UTC)</th><th scope="col">programs</th><th scope="col">analysed</th><th scope="col">errors</th><th scope="col">warnings</th><th scope="col">new</th><th scope="col">gone</th></tr></thead>
            <tbody>{[...runs].reverse().map((run) => (
              <tr key={run.id}><th scope="row">{run.id}</th><td>{run.started.replace("T", " ").replace("Z", "")}</td>{[run.files, run.checked, run.errors, run.warnings, run.new, run.gone].map((n, i) => <td key={i}>{number(n)}</td>)}</tr>
            ))}</tbody>
          </table>
        </div>
      </details>
    </>
  );
}
