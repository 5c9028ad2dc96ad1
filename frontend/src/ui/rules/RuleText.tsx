import Markdown from "markdown-to-jsx/react";
import { type ComponentProps, createContext, type MouseEvent, useContext } from "react";
import { Link } from "wouter";
import { NoSuchRule } from "./NoSuchRule";
import { linkedRule, pictureAddress, ruleText } from "./rulePages";
import classes from "./rules.module.css";

/** What opens another rule in place; undefined: the link leads to its page. */
const OpenRule = createContext<((code: string) => void) | undefined>(undefined);

interface RuleTextProperties {
  /** null: the index of all rules. */
  code: string | null;
  onOpen?: ((code: string) => void) | undefined;
}

/** What a rule forbids, why, an example and the mend: the generated page of the docs. */
export function RuleText({ code, onOpen }: RuleTextProperties) {
  const text = ruleText(code);
  if (text === null) return <NoSuchRule code={code} />;
  return (
    <OpenRule value={onOpen}>
      <Markdown
        className={classes.text}
        options={{ forceBlock: true, overrides: { a: Anchor, img: Picture } }}
      >
        {text}
      </Markdown>
    </OpenRule>
  );
}

function Anchor({ href = "", children }: ComponentProps<"a">) {
  const open = useContext(OpenRule);
  const code = linkedRule(href);
  if (code === null) return <a href={href}>{children}</a>;
  const inPlace = (event: MouseEvent) => {
    if (open === undefined || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    open(code);
  };
  return (
    <Link href={`/rules/${code}`} onClick={inPlace}>
      {children}
    </Link>
  );
}

function Picture({ src = "", alt = "" }: ComponentProps<"img">) {
  return <img src={pictureAddress(src)} alt={alt} className={classes.picture} />;
}
