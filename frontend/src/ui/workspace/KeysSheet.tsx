import { Modal } from "@mantine/core";
import { KEY_TABLE, type KeyBinding } from "../../editor";
import { useScreen, useWorkspace } from "./context";
import classes from "./workspace.module.css";

const REVIEW_KEYS: readonly Pick<KeyBinding, "label" | "words">[] = [
  { label: "G G", words: "Accept the revision (press twice)" },
  { label: "B", words: "Send it back with a reason" },
  { label: "N", words: "Next change" },
];

const GROUPS = [...new Set(KEY_TABLE.map((binding) => binding.group))];

export function KeysSheet() {
  const { screen } = useWorkspace();
  const shown = useScreen((state) => state.keysShown);
  return (
    <Modal opened={shown} onClose={() => screen.setState({ keysShown: false })} title="Keys" size={760}>
      <div className={classes.keys}>
        {GROUPS.map((group) => (
          <KeyGroup key={group} title={group} keys={KEY_TABLE.filter((binding) => binding.group === group)} />
        ))}
        <KeyGroup title="Review" keys={REVIEW_KEYS} />
      </div>
    </Modal>
  );
}

function KeyGroup({ title, keys }: { title: string; keys: readonly Pick<KeyBinding, "label" | "words">[] }) {
  return (
    <section>
      <h3 className="label">{title}</h3>
      <dl className={classes.keyList}>
        {keys.map(({ label, words }) => (
          <div key={`${label} ${words}`}>
            <dt>
              <kbd>{label}</kbd>
            </dt>
            <dd>{words}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}
