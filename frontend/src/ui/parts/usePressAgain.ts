import { useRef } from "react";

const FORGOTTEN_AFTER_MS = 6_000;

/**
 * For an act of one key that cannot be taken back: the first press asks, the second one soon after acts. Another
 * subject in between is asked about anew.
 */
export function usePressAgain(ask: () => void, act: () => void): (subject: string) => void {
  const asked = useRef<{ subject: string; until: number } | null>(null);
  return (subject) => {
    const { current } = asked;
    const again = current?.subject === subject && Date.now() < current.until;
    asked.current = again ? null : { subject, until: Date.now() + FORGOTTEN_AFTER_MS };
    if (again) act();
    else ask();
  };
}
