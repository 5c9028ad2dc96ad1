import { MantineProvider } from "@mantine/core";
import { render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, it, vi } from "vitest";
import type { Change, Findings } from "../../api/types";
import { ChangeList } from "./ChangeList";

const change = (id: number, headline: string): Change => ({
  kind: "lane_segment",
  id,
  categories: ["marking", "type"],
  leaves: [],
  old: {},
  new: {},
  headline,
  detail: "left mark none → solid white",
  exported_as: "",
});
const findings: Findings = {
  changes: [change(7, "Lane 7 repainted"), change(8, "Lane 8 relinked")],
  updates: [
    {
      title: "Road repainted (lane 7): appearance",
      elements: [["lane_segment", 7]],
      macros: { shape: false, appearance: true, function: false, lane_graph: true, lane_number: -1 },
    },
  ],
  violations: [],
};

it("tells each change once, under its update with its macros", () => {
  render(<ChangeList findings={findings} />, { wrapper: MantineProvider });
  const update = screen.getByRole("region", { name: "Road repainted (lane 7)" });
  const chips = within(within(update).getByRole("list", { name: "Macros" })).getAllByRole("listitem");
  expect(chips.map(({ textContent }) => textContent)).toEqual(["appearance", "lane graph", "lane number −1"]);
  expect(update).toHaveTextContent("Lane 7 repainted");
  expect(screen.getByRole("region", { name: "Elsewhere" })).toHaveTextContent("Lane 8 relinked");
});

it("says the categories in words beside the colours", () => {
  render(<ChangeList findings={findings} />, { wrapper: MantineProvider });
  expect(screen.getByRole("button", { name: /Lane 7 repainted/ })).toHaveAccessibleName(/marking, type/);
});

it("selects on click and lights up while the pointer or the focus is on it", async () => {
  const onSelect = vi.fn();
  const onHover = vi.fn();
  render(<ChangeList findings={findings} onSelect={onSelect} onHover={onHover} />, {
    wrapper: MantineProvider,
  });
  const row = screen.getByRole("button", { name: /Lane 7 repainted/ });
  await userEvent.hover(row);
  expect(onHover).toHaveBeenLastCalledWith({ kind: "lane_segment", id: 7 });
  await userEvent.unhover(row);
  expect(onHover).toHaveBeenLastCalledWith(null);
  await userEvent.click(row);
  expect(onSelect).toHaveBeenCalledWith({ kind: "lane_segment", id: 7 });
});
