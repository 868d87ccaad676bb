// How errors and warnings went from run to run: a small drawing, and the same as a table for those who do not see it.
import type { Run } from "./data";
import { number } from "./model";

const width = 640, height = 160, left = 44, bottom = 24, top = 10;

export function Trend({ runs }: { runs: Run[] }) {
  const shown = runs.slice(-60);
  const most = Math.max(1, ...shown.map((run) => Math.max(run.errors, run.warnings)));
  const x = (i: number) => left + (shown.length < 2 ? (width - left) / 2 : (i * (width - left - 12)) / (shown.length - 1));
  const y = (n: number) => top + (height - top - bottom) * (1 - n / most);
  const line = (key: "errors" | "warnings") => shown.map((run, i) => `${x(i)},${y(run[key])}`).join(" ");
  return (
    <>
      <svg class="trend" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`errors and warnings in the last ${shown.length} runs; the table below has the numbers`}>
        {[0, most].map((n) => (
          <g key={n}><line class="grid" x1={left} x2={width} y1={y(n)} y2={y(n)} /><text x={left - 8} y={y(n) + 4} text-anchor="end">{number(n)}</text></g>
        ))}
        {(["warnings", "errors"] as const).map((key) => (
          <g key={key} class={key}>
            <polyline points={line(key)} />
            {shown.map((run, i) => <circle key={run.id} cx={x(i)} cy={y(run[key])} r={shown.length > 30 ? 2 : 3.5}><title>{`run ${run.id}: ${number(run[key])} ${key}`}</title></circle>)}
          </g>
        ))}
        <text x={x(0)} y={height - 4} text-anchor={shown.length < 2 ? "middle" : "start"}>run {shown[0]?.id}</text>
        {shown.length > 1 && <text x={x(shown.length - 1)} y={height - 4} text-anchor="end">run {shown[shown.length - 1].id}</text>}
      </svg>
      <p class="legend"><span class="key error">errors</span> <span class="key warning">warnings</span></p>
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
