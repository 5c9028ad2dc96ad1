import { expect, it } from "vitest";
import { ago, day, duration, shortLogName } from "./words";

it("names logs so that they can be told apart at a glance", () => {
  expect(shortLogName("7fab2350-7eaf-3b7e-a39d-6937a4c1bede")).toBe("7fab2350");
  expect(shortLogName("VnB0yY6d__Summer_2020")).toBe("VnB0yY6d");
  expect(shortLogName("VnB0yY6dGS3SRF0WBoJA2KWfBEdv4e8m__Summer_2020")).toBe("VnB0yY6dGS3SRF0WBoJA…");
});

it("says how long ago something was", () => {
  const now = Date.UTC(2026, 5, 1, 12);
  expect(ago(now - 2_000, now)).toBe("just now");
  expect(ago(now - 59_000, now)).toBe("59 s ago");
  expect(ago(now - 3_600_000, now)).toBe("1 h ago");
  expect(duration(4 * 24 * 3600)).toBe("4 d");
  expect(ago(now + 60_000, now)).toBe("just now");
});

it("writes days the same in every country", () => {
  expect(day("2026-03-09T12:00:00Z")).toBe("2026-03-09");
});
