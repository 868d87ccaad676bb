// How far a program goes along each axis: a small table beside its lines.
import type { Extents, LineOf } from "./data";
import { link } from "./route";

const reasons: Record<string, string> = {
  place: "not known where it ends",
  arc: "an arc of which only the end is known",
  units: "inches or millimeters, by the way to it",
  code: "a code that is not followed",
  compensation: "cutter compensation: the contour counts as it is written",
};

const shown = (value: number) => String(Math.round(value * 1e4) / 1e4);

function At({ at, children }: { at: LineOf; children: string }) {
  return at.file < 0 ? <>{children}</> : <a href={link("program", at.file, { line: String(at.line) })} title={`line ${at.line}`}>{children}</a>;
}

function titleOf({ system, g92, from_start }: Extents["origins"][number]): string {
  const name = system === "machine" ? "Machine (G53)" : system ?? "Several coordinate systems";
  return name + (g92 ? " with G92" : "") + (from_start ? ", counted from where the machine stands" : "");
}

export function ExtentsTable({ extents }: { extents: Extents }) {
  const missing = [...extents.unknown.map(({ file, line, axes, why }) => ({ at: { file, line }, words: `${axes.join(" ")}: ${reasons[why]}` })),
    ...(extents.stops_at ? [{ at: extents.stops_at, words: "a run stops" }] : [])];
  return (
    <details class="extents" open>
      <summary>Extents in {extents.unit === "inch" ? "inches" : "mm"}</summary>
      {extents.origins.map((origin) => (
        <table key={titleOf(origin)}>
          <caption>{titleOf(origin)}</caption>
          <thead><tr><th scope="col">Axis</th><th scope="col">Least</th><th scope="col">Greatest</th></tr></thead>
          <tbody>{Object.entries(origin.axes).map(([axis, range]) => (
            <tr key={axis}><th scope="row">{axis}</th><td><At at={range.least_at}>{shown(range.least)}</At></td><td><At at={range.greatest_at}>{shown(range.greatest)}</At></td></tr>
          ))}</tbody>
        </table>
      ))}
      {missing.length > 0 && <><p>Not included:</p><ul class="plain">{missing.map(({ at, words }, i) => <li key={i}><At at={at}>{`line ${at.line}`}</At> {words}</li>)}</ul></>}
    </details>
  );
}
