import { MantineProvider } from "@mantine/core";
import { render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, it, vi } from "vitest";
import { RulePage } from "./RulePage";
import { RuleText } from "./RuleText";

const shown = { wrapper: MantineProvider };

it("tells what, why and how to mend, with the picture", () => {
  render(<RulePage code="replacement.unjustified" />, shown);
  expect(screen.getByRole("heading", { level: 1 })).toHaveTextContent("Replacement unjustified");
  for (const name of ["What", "Why", "Example", "How to mend"]) {
    expect(screen.getByRole("heading", { level: 2, name })).toBeVisible();
  }
  expect(screen.getByRole("img")).toHaveAttribute("src", expect.stringContaining(".svg"));
  expect(document.body).not.toHaveTextContent("Written by");
});

it("lists every rule with the way to its page", () => {
  render(<RulePage />, shown);
  const links = within(screen.getByRole("table")).getAllByRole("link");
  expect(links.length).toBeGreaterThan(12);
  for (const link of links) expect(link).toHaveAttribute("href", `/rules/${link.textContent}`);
});

it("opens another rule in place where it is asked to", async () => {
  const onOpen = vi.fn();
  render(<RuleText code={null} onOpen={onOpen} />, shown);
  await userEvent.click(screen.getByRole("link", { name: "link.gap" }));
  expect(onOpen).toHaveBeenCalledWith("link.gap");
});

it("says so when there is no such rule", () => {
  render(<RulePage code="no.such" />, shown);
  expect(screen.getByText(/There is no rule/)).toHaveTextContent("no.such");
});
