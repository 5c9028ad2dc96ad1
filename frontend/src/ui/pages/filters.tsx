import { Select, TextInput } from "@mantine/core";
import { useDebouncedCallback } from "@mantine/hooks";
import { IconSearch } from "@tabler/icons-react";
import { useState } from "react";
import type { Filter } from "./useFilter";

/** The cities of Argoverse 2. */
const CITIES = ["ATX", "DTW", "MIA", "PAO", "PIT", "WDC"];
const SPLITS = ["train", "val", "test"];

export function SearchField({ filter, label }: { filter: Filter; label: string }) {
  const asked = filter.value("q");
  const [text, setText] = useState(asked);
  const [seen, setSeen] = useState(asked);
  const send = useDebouncedCallback((q: string) => filter.set({ q }), 250);
  // The address changed by other means, e.g. by clearing the filter.
  if (asked !== seen) {
    setSeen(asked);
    setText(asked);
  }
  return (
    <TextInput
      aria-label={label}
      placeholder={label}
      leftSection={<IconSearch size={14} />}
      value={text}
      onChange={(event) => {
        setText(event.currentTarget.value);
        send(event.currentTarget.value);
      }}
    />
  );
}

interface ChoiceProperties {
  filter: Filter;
  name: string;
  label: string;
  options: readonly { value: string; label: string }[];
  width?: number;
}

export function Choice({ filter, name, label, options, width = 130 }: ChoiceProperties) {
  return (
    <Select
      aria-label={label}
      placeholder={label}
      data={options}
      value={filter.value(name) || null}
      clearable
      w={width}
      onChange={(value) => filter.set({ [name]: value })}
    />
  );
}

const plain = (values: readonly string[]) => values.map((value) => ({ value, label: value }));

export function CityAndSplit({ filter }: { filter: Filter }) {
  return (
    <>
      <Choice filter={filter} name="city" label="All cities" options={plain(CITIES)} />
      <Choice filter={filter} name="split" label="All splits" options={plain(SPLITS)} />
    </>
  );
}
