import { MantineProvider } from "@mantine/core";
import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, expect, it, vi } from "vitest";
import { SignInForm } from "./SignInForm";

afterEach(() => vi.unstubAllGlobals());

it("shows what the server says of a failed sign-in, and lets the password be typed again", async () => {
  const refusal = {
    code: "session.refused",
    message: "Name and password do not belong together.",
    mend: "Try again, or ask an admin for a new password.",
    request_id: "r-17",
  };
  vi.stubGlobal("fetch", () => Promise.resolve(new Response(JSON.stringify(refusal), { status: 401 })));
  const onSignedIn = vi.fn();
  render(<SignInForm onSignedIn={onSignedIn} />, { wrapper: MantineProvider });
  await userEvent.type(screen.getByLabelText("Name"), "annotator");
  await userEvent.type(screen.getByLabelText("Password"), "wrong");
  await userEvent.click(screen.getByRole("button", { name: "Sign in" }));

  const alert = await screen.findByRole("alert");
  expect(alert).toHaveTextContent(refusal.message);
  expect(alert).toHaveTextContent(refusal.mend);
  expect(alert).toHaveTextContent("request r-17");
  expect(screen.getByLabelText("Password")).toHaveValue("");
  expect(screen.getByLabelText("Name")).toHaveValue("annotator");
  expect(onSignedIn).not.toHaveBeenCalled();
});
