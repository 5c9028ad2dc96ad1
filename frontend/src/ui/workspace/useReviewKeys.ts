import { useEffect, useEffectEvent } from "react";

/** G and B decide while a review is open, also with the focus on the map, where B is a drawing tool otherwise. */
export function useReviewKeys(active: boolean, accept: () => void, sendBack: () => void): void {
  const decide = useEffectEvent((event: KeyboardEvent) => {
    const typing = event.target instanceof HTMLElement && event.target.matches("input, textarea");
    if (typing || event.ctrlKey || event.metaKey || event.altKey || event.repeat) return;
    const key = event.key.toLowerCase();
    if (key !== "g" && key !== "b") return;
    event.preventDefault();
    event.stopPropagation();
    if (key === "g") accept();
    else sendBack();
  });
  useEffect(() => {
    if (!active) return;
    const listen = (event: KeyboardEvent) => decide(event);
    document.addEventListener("keydown", listen, true);
    return () => document.removeEventListener("keydown", listen, true);
  }, [active]);
}
