// What a rule finds and why: its page, as owlint explains it.
import { Marked, type Token, type Tokens } from "marked";
import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import type { Model } from "./model";
import { link } from "./route";

const marked = new Marked();

/** Elements from Markdown; never from markup in it, which stays text. */
function elements(tokens: Token[] | undefined): ComponentChildren[] {
  return (tokens ?? []).map((token, i) => {
    const inner = () => elements((token as Tokens.Generic).tokens);
    switch (token.type) {
      case "heading": return token.depth === 1 ? <h2 key={i}>{inner()}</h2> : <h3 key={i}>{inner()}</h3>;
      case "paragraph": return <p key={i}>{inner()}</p>;
      case "code": return <pre key={i} tabIndex={0}><code>{token.text}</code></pre>;
      case "list": return token.ordered ? <ol key={i}>{elements(token.items)}</ol> : <ul key={i}>{elements(token.items)}</ul>;
      case "list_item": return <li key={i}>{inner()}</li>;
      case "blockquote": return <blockquote key={i}>{inner()}</blockquote>;
      case "table": return (
        <table key={i}>
          <thead><tr>{(token as Tokens.Table).header.map((cell, n) => <th key={n} scope="col">{elements(cell.tokens)}</th>)}</tr></thead>
          <tbody>{(token as Tokens.Table).rows.map((row, r) => <tr key={r}>{row.map((cell, n) => <td key={n}>{elements(cell.tokens)}</td>)}</tr>)}</tbody>
        </table>
      );
      case "strong": return <strong key={i}>{inner()}</strong>;
      case "em": return <em key={i}>{inner()}</em>;
      case "codespan": return <code key={i}>{token.text}</code>;
      case "br": return <br key={i} />;
      case "space": return null;
      case "text": return (token as Tokens.Text).tokens ? <span key={i}>{inner()}</span> : unescaped(token.text);
      case "link": return <span key={i}>{inner()}</span>;
      default: return "text" in token ? token.text : token.raw;
    }
  });
}

const unescaped = (text: string) => text.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, '"').replace(/&#39;/g, "'").replace(/&amp;/g, "&");

export function RulePage({ model, code }: { model: Model; code: string }) {
  const rule = model.index.rules.find((r) => r.code === code);
  const content = useMemo(() => elements(marked.lexer(rule?.markdown ?? "")), [code]);
  if (!rule) return <p class="empty">No finding of this audit is of the rule {code}.</p>;
  return <article class="rule">{content}<p><a href={link("findings", "", { rule: code })}>All findings of {code}</a></p></article>;
}
