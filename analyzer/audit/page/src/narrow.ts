// Whether the page is as narrow as on a phone; page.css draws the line at the same width.
import { useEffect, useState } from "preact/hooks";

const query = matchMedia("(max-width: 800px)");

export function useNarrow(): boolean {
  const [narrow, set] = useState(query.matches);
  useEffect(() => {
    const changed = () => set(query.matches);
    query.addEventListener("change", changed);
    return () => query.removeEventListener("change", changed);
  }, []);
  return narrow;
}
