// What completion offers, as an editor shows it.
import assert from 'node:assert/strict';
import * as places from './places.mjs';

/** What the line with the cursor `‸` would be with each of the offered items; filtered and sorted as an editor does. */
export async function offered(client, text, name = 'draft.ngc') {
  const index = places.find(text, '‸');
  client.open(name, text.replace('‸', ''));
  const position = places.positionOf(client.text(name), index, client.encoding);
  const result = await client.request('textDocument/completion', client.document(name, { position, context: { triggerKind: 1 } }));
  client.closeDocument(name);
  const items = [...(result?.items ?? result ?? [])].sort((a, b) => ((a.sortText ?? a.label) < (b.sortText ?? b.label) ? -1 : 1));
  const before = client.text(name).split('\n')[position.line];
  return items.flatMap((item) => {
    const edit = item.textEdit ?? { range: result.itemDefaults?.editRange, newText: item.textEditText ?? item.insertText ?? item.label };
    let range = edit.range ?? edit.replace ?? edit.insert;
    if (!range) {
      const typed = /\w*$/.exec(before.slice(0, position.character))[0];
      range = { start: { line: position.line, character: position.character - typed.length }, end: position };
    }
    assert.ok(range.start.line === position.line && range.end.line === position.line, `${item.label}: its edit is on the line`);
    const typed = before.slice(range.start.character, position.character);
    if (!(item.filterText ?? item.label).toLowerCase().startsWith(typed.toLowerCase().trimStart())) return [];
    const plain = item.insertTextFormat === 2 ? edit.newText.replace(/\$\{\d+:?([^}]*)\}|\$\d+/g, '$1') : edit.newText;
    return [{ ...item, line: before.slice(0, range.start.character) + plain + before.slice(range.end.character) }];
  });
}
