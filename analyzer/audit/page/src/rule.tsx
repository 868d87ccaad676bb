// What a rule finds and why: its page, as owlint explains it.
import { Marked, type Token, type Tokens } from "marked";
import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { CodeLines } from "./code";
import type { Model } from "./model";
import { link } from "./route";

const marked = new Marked();

/** Elements from Markdown; never from markup in it, which stays text. `top` is the level of its first heading. */
function elements(tokens: Token[] | undefined, top: 1 | 2): ComponentChildren[] {
  return (tokens ?? []).map((token, i) => {
    const inner = () => elements((token as Tokens.Generic).tokens, top);
    switch (token.type) {
      case "heading": {
        const Heading = `h${top + (token.depth > 1 ? 1 : 0)}` as "h1";
        return <Heading key={i}>{inner()}</Heading>;
      }
      case "paragraph": return <p key={i}>{inner()}</p>;
      case "code": return <pre key={i} tabIndex={0}><code><CodeLines text={token.text} language="program" /></code></pre>;
      case "list": return token.ordered ? <ol key={i}>{elements(token.items, top)}</ol> : <ul key={i}>{elements(token.items, top)}</ul>;
      case "list_item": return <li key={i}>{inner()}</li>;
      case "blockquote": return <blockquote key={i}>{inner()}</blockquote>;
      case "table": return (
        <table key={i}>
          <thead><tr>{(token as Tokens.Table).header.map((cell, n) => <th key={n} scope="col">{elements(cell.tokens, top)}</th>)}</tr></thead>
          <tbody>{(token as Tokens.Table).rows.map((row, r) => <tr key={r}>{row.map((cell, n) => <td key={n}>{elements(cell.tokens, top)}</td>)}</tr>)}</tbody>
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

export function RulePage({ model, code, top = 2 }: { model: Model; code: string; top?: 1 | 2 }) {
  const rule = model.index.rules.find((r) => r.code === code);
  const content = useMemo(() => elements(marked.lexer(rule?.markdown ?? ""), top), [code, top]);
  if (!rule) return <>{top === 1 && <h1>{code}</h1>}<p class="empty">This audit has no finding of the rule {code}.</p></>;
  return <article class="rule">{content}<p><a href={link("findings", "", { rule: code })}>All findings of {code}</a></p></article>;
}
