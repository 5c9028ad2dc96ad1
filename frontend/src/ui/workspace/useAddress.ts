import { useEffect, useRef } from "react";
import { useSearchParams } from "wouter";
import { keyText, parseKey } from "../../editor";
import { useEditor, useWorkspace } from "./context";

/** Keeps the selected element in the address, and selects the one that the address names when the task opens. */
export function useAddress(): void {
  const { editor } = useWorkspace();
  const [parameters, setParameters] = useSearchParams();
  const named = useRef(parameters.get("element"));
  const selected = useEditor((state) => (state.selection === null ? null : keyText(state.selection)));

  useEffect(() => {
    const key = named.current === null ? null : parseKey(named.current);
    named.current = null;
    if (key === null) return;
    editor.actions.select(key);
  }, [editor]);

  useEffect(() => {
    if (named.current !== null) return;
    setParameters(
      (before) => {
        const next = new URLSearchParams(before);
        if (selected === null) next.delete("element");
        else next.set("element", selected);
        return next;
      },
      { replace: true },
    );
  }, [selected, setParameters]);
}
