import { Button, Checkbox, Group, NumberInput, Popover, Stack } from "@mantine/core";
import { IconCheck, IconX } from "@tabler/icons-react";
import { type SubmitEvent, useState } from "react";
import type { Declaration, Macros } from "../../../api/types";
import classes from "./left.module.css";

const NAMES = [
  ["shape", "Shape", "widened, narrowed, bent"],
  ["appearance", "Appearance", "repainted, crossings"],
  ["function", "Function", "reserved or opened"],
  ["lane_graph", "Lane graph", "lanes come, go, lead elsewhere"],
] as const;

interface DeclareProperties {
  /** What follows from the changes. */
  derived: Macros;
  declared: Declaration | null;
  editable: boolean;
  /** null: withdraws the declaration. */
  onDeclare: (macros: Macros | null) => void;
}

/** The macros of an update as the annotator states them, checked against those that follow. */
export function Declare({ derived, declared, editable, onDeclare }: DeclareProperties) {
  const [open, setOpen] = useState(false);
  const close = () => setOpen(false);
  const mark = declared !== null && <Mark fits={sameMacros(declared.macros, derived)} />;
  if (!editable) return mark;
  return (
    <Popover opened={open} onChange={setOpen} position="bottom-end" width={250} trapFocus withinPortal>
      <Popover.Target>
        <button
          type="button"
          className={classes.declare}
          aria-expanded={open}
          title="State the macros yourself; the check compares them with those that follow"
          onClick={() => setOpen(!open)}
        >
          {declared === null ? "Declare…" : mark}
        </button>
      </Popover.Target>
      <Popover.Dropdown>
        <DeclareForm
          initial={declared?.macros ?? derived}
          withdrawable={declared !== null}
          onDone={(macros) => {
            close();
            onDeclare(macros);
          }}
          onCancel={close}
        />
      </Popover.Dropdown>
    </Popover>
  );
}

function sameMacros(a: Macros, b: Macros): boolean {
  return NAMES.every(([name]) => a[name] === b[name]) && a.lane_number === b.lane_number;
}

function Mark({ fits }: { fits: boolean }) {
  const Icon = fits ? IconCheck : IconX;
  return (
    <span className={classes.declared} data-fits={fits}>
      {fits ? "declared" : "declared otherwise"} <Icon size={13} aria-hidden />
    </span>
  );
}

interface DeclareFormProperties {
  initial: Macros;
  withdrawable: boolean;
  onDone: (macros: Macros | null) => void;
  onCancel: () => void;
}

function DeclareForm({ initial, withdrawable, onDone, onCancel }: DeclareFormProperties) {
  const [macros, setMacros] = useState<Macros>(initial);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    onDone(macros);
  };
  return (
    <form onSubmit={submit} aria-label="Declare macros">
      <Stack gap={8}>
        {NAMES.map(([name, label, description]) => (
          <Checkbox
            key={name}
            size="xs"
            label={label}
            description={description}
            checked={macros[name]}
            onChange={(event) => setMacros({ ...macros, [name]: event.currentTarget.checked })}
          />
        ))}
        <NumberInput
          size="xs"
          label="Lane number"
          description="lanes more (+) or fewer (−) on the local road"
          allowDecimal={false}
          min={-20}
          max={20}
          value={macros.lane_number}
          onChange={(value) => setMacros({ ...macros, lane_number: Number(value) || 0 })}
        />
        <Group justify="flex-end" gap={6}>
          {withdrawable ? (
            <Button size="compact-xs" variant="subtle" onClick={() => onDone(null)}>
              Withdraw
            </Button>
          ) : (
            <Button size="compact-xs" variant="subtle" onClick={onCancel}>
              Cancel
            </Button>
          )}
          <Button size="compact-xs" type="submit">
            Declare
          </Button>
        </Group>
      </Stack>
    </form>
  );
}
