import { useSearchParams } from "wouter";

/** A list's filter, kept in the address so that it can be sent and survives reloading. */
export function useFilter() {
  const [parameters, setParameters] = useSearchParams();
  const value = (name: string) => parameters.get(name) ?? "";
  const values = (name: string) => parameters.getAll(name);
  /** Empty values leave the address; any change but of the page goes back to the first page. */
  const set = (changes: Record<string, string | string[] | null>) =>
    setParameters(
      (before) => {
        const next = new URLSearchParams(before);
        if (!("page" in changes)) next.delete("page");
        for (const [name, given] of Object.entries(changes)) {
          next.delete(name);
          const list = Array.isArray(given) ? given : [given ?? ""];
          for (const one of list) if (one !== "") next.append(name, one);
        }
        return next;
      },
      { replace: true },
    );
  const page = Math.max(1, Number.parseInt(value("page"), 10) || 1);
  const filtered = [...parameters.keys()].some((name) => name !== "page");
  return { value, values, set, page, filtered, clear: () => setParameters({}, { replace: true }) };
}

export type Filter = ReturnType<typeof useFilter>;
