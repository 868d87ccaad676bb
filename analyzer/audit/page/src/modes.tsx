// The modes in effect along a program: what the chosen line finds, and which lines find others than the line above.
import type { Modes, Place } from "./data";
import { plural } from "./model";
import { link } from "./route";
import { visible } from "./words";

type Value = [value: string, places: Place[]];

/** By number of name; null where no run gets to the line. */
export function modesAt(modes: Modes, line: number): Map<number, Value> | null {
  const now = new Map<number, Value>();
  let reached = true;
  for (const [from, changes] of modes.steps) {
    if (from > line) break;
    reached = changes !== null;
    for (const [name, value, places] of changes ?? []) now.set(name, [value, places]);
  }
  return reached ? now : null;
}

/** What lines tell beside their code: modes that the line above has not set for all to see. */
export function notesOf(modes: Modes): Map<number, string[]> {
  const notes = new Map<number, string[]>();
  modes.steps.forEach(([line, changes], step) => {
    if (step === 0 || changes === null) return;
    const above = (places: Place[]) => places.length === 1 && places[0] === line - 1;
    const told = changes.filter(([name, , places]) => modes.names[name][1] === 1 && !above(places));
    if (told.length > 0) notes.set(line, told.map(([name, value]) => `${modes.names[name][0]} ${value}`));
  });
  return notes;
}

function Places({ file, places }: { file: number; places: Place[] }) {
  const words = (place: Place) => (typeof place === "number" ? `line ${place}` : `${visible(place[2])}:${place[1]}`);
  const target = (place: Place) => (typeof place === "number" ? [file, place] : place);
  return <>{places.map((place, i) => {
    const [to, line] = target(place) as [number, number];
    return <span key={i}>{i > 0 && ", "}{to < 0 ? words(place) : <a href={link("program", to, { line: String(line) })}>{words(place)}</a>}</span>;
  })}</>;
}

function Rows({ file, modes, rows }: { file: number; modes: Modes; rows: [number, Value][] }) {
  return (
    <table class="modes">
      <tbody>{rows.map(([name, [value, places]]) => (
        <tr key={name}><th scope="row">{modes.names[name][0]}</th><td>{value}</td><td><Places file={file} places={places} /></td></tr>
      ))}</tbody>
    </table>
  );
}

export function ModesPanel({ file, modes, line }: { file: number; modes: Modes; line: number }) {
  if (line === 0) return <section class="panel modes-panel"><h2>Modes</h2><p class="more">Choose a line by its number to see which modes are in effect there.</p></section>;
  const now = modesAt(modes, line);
  if (now === null) return <section class="panel modes-panel"><h2>Modes on line {line}</h2><p class="more">No run gets to this line.</p></section>;
  const all = [...now].sort(([a], [b]) => a - b);
  const set = all.filter(([, [, places]]) => places.length > 0);
  const others = all.filter(([, [, places]]) => places.length === 0);
  return (
    <section class="panel modes-panel">
      <h2>Modes on line {line}</h2>
      {set.length > 0 ? <Rows file={file} modes={modes} rows={set} /> : <p class="more">No line has set a mode before.</p>}
      {others.length > 0 && <details><summary>{plural(others.length, "mode")} that no line has set</summary><Rows file={file} modes={modes} rows={others} /></details>}
    </section>
  );
}
