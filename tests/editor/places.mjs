// Places in texts: positions in the three encodings of LSP 3.17, edits, and workspace edits on a map of texts.
import assert from 'node:assert/strict';

/** How long a piece of a line is in an encoding's units. */
export function width(text, encoding) {
  if (encoding === 'utf-8') return Buffer.byteLength(text, 'utf8');
  return encoding === 'utf-32' ? [...text].length : text.length;
}

/** Indexes at which lines begin; the protocol knows \n, \r\n and \r. */
function lineStarts(text) {
  return [0, ...[...text.matchAll(/\r\n|\n|\r/g)].map((end) => end.index + end[0].length)];
}

export function positionOf(text, index, encoding) {
  const starts = lineStarts(text);
  let line = starts.length - 1;
  while (starts[line] > index) --line;
  return { line, character: width(text.slice(starts[line], index), encoding) };
}

/** The index of a position; fails for one that does not stand between two characters of a line. */
export function indexOf(text, position, encoding) {
  const start = lineStarts(text)[position.line];
  assert.notEqual(start, undefined, `there is no line ${position.line}`);
  const line = text.slice(start).split(/\r\n|\n|\r/, 1)[0];
  let index = 0;
  while (index < line.length && width(line.slice(0, index), encoding) < position.character) {
    index += line.codePointAt(index) > 0xffff ? 2 : 1;
  }
  assert.equal(width(line.slice(0, index), encoding), position.character, `character ${position.character} of line ${position.line}: ${line}`);
  return start + index;
}

/** The index of a piece of text: the only one, or the `nth` from 0 of `[piece, nth]`. */
export function find(text, piece) {
  const [needle, nth] = Array.isArray(piece) ? piece : [piece, undefined];
  const all = [];
  for (let at = text.indexOf(needle); at >= 0; at = text.indexOf(needle, at + 1)) all.push(at);
  if (nth === undefined) assert.equal(all.length, 1, `\`${needle}\` stands there ${all.length} times`);
  assert.ok(all.length > (nth ?? 0), `\`${needle}\` is not there`);
  return all[nth ?? 0];
}

export function rangeOf(text, piece, encoding) {
  const at = find(text, piece);
  const needle = Array.isArray(piece) ? piece[0] : piece;
  return { start: positionOf(text, at, encoding), end: positionOf(text, at + needle.length, encoding) };
}

export function slice(text, range, encoding) {
  return text.slice(indexOf(text, range.start, encoding), indexOf(text, range.end, encoding));
}

/** The text after edits that must not overlap, and that all speak of the text before them. */
export function applyEdits(text, edits, encoding) {
  const spans = (edits ?? []).map((edit, order) => ({
    from: indexOf(text, edit.range.start, encoding),
    to: indexOf(text, edit.range.end, encoding),
    order,
    newText: edit.newText,
  }));
  spans.sort((a, b) => a.from - b.from || a.order - b.order);
  let out = '';
  let at = 0;
  for (const span of spans) {
    assert.ok(span.from >= at && span.to >= span.from, 'edits overlap');
    out += text.slice(at, span.from) + span.newText;
    at = span.to;
  }
  return out + text.slice(at);
}

/** Texts by uri after a workspace edit, in the order of its changes. */
export function applyWorkspaceEdit(texts, edit, encoding) {
  const out = { ...texts };
  for (const [uri, edits] of Object.entries(edit.changes ?? {})) {
    assert.ok(uri in out, `an edit of ${uri}, which is not there`);
    out[uri] = applyEdits(out[uri], edits, encoding);
  }
  for (const change of edit.documentChanges ?? []) {
    if (change.kind === 'rename') {
      assert.ok(change.oldUri in out, `a renaming of ${change.oldUri}, which is not there`);
      assert.ok(!(change.newUri in out), `${change.newUri} is there already`);
      out[change.newUri] = out[change.oldUri];
      delete out[change.oldUri];
    } else {
      assert.equal(change.kind, undefined, 'only edits and renamings are expected');
      assert.ok(change.textDocument.uri in out, `an edit of ${change.textDocument.uri}, which is not there`);
      out[change.textDocument.uri] = applyEdits(out[change.textDocument.uri], change.edits, encoding);
    }
  }
  return out;
}

function before(a, b) {
  return a.line < b.line || (a.line === b.line && a.character <= b.character);
}

/** Whether `outer` holds all of `inner`. */
export function contains(outer, inner) {
  return before(outer.start, inner.start) && before(inner.end, outer.end);
}
