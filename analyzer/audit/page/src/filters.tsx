// What stands above a list: a search, and what else narrows or orders it. On a phone all but the search is folded.
import type { ComponentChildren } from "preact";
import { useNarrow } from "./narrow";
import { replaceQuery } from "./route";

export type Choice = { name: string; key: string; choices: [string, string][] };

/** Sets one word of the address; the empty choice takes it out. */
export function choose(query: URLSearchParams, key: string, value: string) {
  const next = new URLSearchParams(query);
  value ? next.set(key, value) : next.delete(key);
  replaceQuery(next);
}

export function Filters({ query, placeholder, selects, extra }: { query: URLSearchParams; placeholder: string; selects: Choice[]; extra?: ComponentChildren }) {
  const narrow = useNarrow();
  const made = selects.map(({ name, key, choices }) => (
    <label key={key}>{name}<select aria-label={name} value={query.get(key) ?? ""} onChange={(e) => choose(query, key, e.currentTarget.value)}>{choices.map(([value, words]) => <option key={value} value={value}>{words}</option>)}</select></label>
  ));
  const used = selects.filter(({ key }) => query.get(key)).length;
  return (
    <form class="filters" role="search" onSubmit={(e) => e.preventDefault()}>
      <label class="search">Search<input type="search" id="search" value={query.get("q") ?? ""} placeholder={placeholder} onInput={(e) => choose(query, "q", e.currentTarget.value)} /></label>
      {narrow ? <details><summary>Filter and sort{used > 0 && ` (${used} chosen)`}</summary><div class="filters">{made}</div></details> : made}
      {extra}
    </form>
  );
}
