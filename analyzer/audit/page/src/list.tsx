// A list of any length: only the rows that are in view exist. One row takes the focus; arrows, Page, Home and End move it.
import { Virtualizer, defaultRangeExtractor, elementScroll, observeElementOffset, observeElementRect } from "@tanstack/virtual-core";
import type { Range } from "@tanstack/virtual-core";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useMemo, useReducer, useRef, useState } from "preact/hooks";

interface Props {
  label: string;
  count: number;
  rowHeight: number;
  href: (i: number) => string;
  row: (i: number) => ComponentChildren;
}

export function List({ label, count, rowHeight, href, row }: Props) {
  const scroller = useRef<HTMLDivElement>(null);
  const [, redraw] = useReducer((n: number) => n + 1, 0);
  const [active, setActive] = useState(0);
  const wanted = useRef(-1);  // the row that takes the focus as soon as it exists
  const options = {
    count,
    getScrollElement: () => scroller.current,
    estimateSize: () => rowHeight,
    overscan: 8,
    // The row with the focus exists wherever the list is scrolled to: without it the focus would be lost.
    rangeExtractor: (range: Range) => [...new Set([...defaultRangeExtractor(range), ...(active < count ? [active] : [])])].sort((a, b) => a - b),
    scrollToFn: elementScroll,
    observeElementRect,
    observeElementOffset,
    onChange: () => redraw(0),
  };
  const virtual = useMemo(() => new Virtualizer<HTMLDivElement, HTMLElement>(options), []);
  virtual.setOptions(options);
  useLayoutEffect(() => virtual._didMount(), [virtual]);
  useLayoutEffect(() => virtual._willUpdate());
  useEffect(() => { virtual.measure(); }, [rowHeight]);
  useEffect(() => { setActive(0); wanted.current = -1; scroller.current?.scrollTo(0, 0); }, [count]);
  useEffect(() => {
    if (wanted.current < 0) return;
    const link = scroller.current?.querySelector<HTMLAnchorElement>(`[data-index="${wanted.current}"] a`);
    if (link) { wanted.current = -1; link.focus({ preventScroll: true }); }
  });

  const move = (event: KeyboardEvent) => {
    const page = Math.max(1, Math.floor((scroller.current?.clientHeight ?? rowHeight) / rowHeight) - 1);
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -count, End: count };
    const step = steps[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const next = Math.min(count - 1, Math.max(0, active + step));
    wanted.current = next;
    setActive(next);
    virtual.scrollToIndex(next);
    redraw(0);
  };

  return (
    <div class="list" role="list" aria-label={label} ref={scroller} onKeyDown={move}>
      <div role="presentation" style={{ height: `${virtual.getTotalSize()}px` }}>
        {virtual.getVirtualItems().map(({ index, start }) => (
          <div key={index} data-index={index} class="row" role="listitem" aria-setsize={count} aria-posinset={index + 1}
            style={{ transform: `translateY(${start}px)`, height: `${rowHeight}px` }}>
            <a href={href(index)} tabIndex={index === active ? 0 : -1} onFocus={() => setActive(index)}>{row(index)}</a>
          </div>
        ))}
      </div>
    </div>
  );
}
