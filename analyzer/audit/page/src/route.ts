// Where one is: the part of the address behind `#`, so that back, forward and links work in a file without a server.
import { useEffect, useState } from "preact/hooks";

export interface Route { name: string; id: string; query: URLSearchParams }

export function readRoute(): Route {
  const [path, query] = location.hash.replace(/^#\/?/, "").split("?", 2);
  const [name = "", ...rest] = path.split("/");
  return { name, id: decodeURIComponent(rest.join("/")), query: new URLSearchParams(query ?? "") };
}

export function useRoute(): Route {
  const [route, set] = useState(readRoute);
  useEffect(() => {
    const changed = () => set(readRoute());
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, []);
  return route;
}

export function link(name: string, id: string | number = "", query: Record<string, string | undefined> = {}): string {
  const words = new URLSearchParams();
  for (const [key, value] of Object.entries(query)) if (value) words.set(key, value);
  const text = words.toString();
  return `#/${name}${id === "" ? "" : `/${encodeURIComponent(id)}`}${text ? `?${text}` : ""}`;
}

/** Changes the query without a new step in the history: while somebody is typing. */
export function replaceQuery(query: URLSearchParams) {
  const { name, id } = readRoute();
  const address = link(name, id, Object.fromEntries(query));
  history.replaceState(null, "", address);
  dispatchEvent(new HashChangeEvent("hashchange"));
}
