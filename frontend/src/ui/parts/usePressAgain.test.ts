import { renderHook } from "@testing-library/react";
import { expect, it, vi } from "vitest";
import { usePressAgain } from "./usePressAgain";

function pressing() {
  const ask = vi.fn();
  const act = vi.fn();
  const { result } = renderHook(() => usePressAgain(ask, act));
  return { press: result.current, ask, act };
}

it("asks first, and acts when pressed again", () => {
  const { press, ask, act } = pressing();
  press("task 1");
  expect([ask.mock.calls.length, act.mock.calls.length]).toEqual([1, 0]);
  press("task 1");
  expect([ask.mock.calls.length, act.mock.calls.length]).toEqual([1, 1]);
});

it("asks anew about another subject, and after a while", () => {
  vi.useFakeTimers();
  const { press, act } = pressing();
  press("task 1");
  press("task 2");
  vi.advanceTimersByTime(10_000);
  press("task 2");
  expect(act).not.toHaveBeenCalled();
  vi.useRealTimers();
});
