import { Button, TextInput } from "@mantine/core";
import { newPassword, passwordFault } from "./password";

/** A password that an admin hands to somebody: shown, because it has to be passed on. */
export function NewPasswordField({
  value,
  onChange,
}: {
  value: string;
  onChange: (password: string) => void;
}) {
  return (
    <TextInput
      label="Password"
      description="Pass it on; they can change it under “Your account”."
      classNames={{ input: "mono" }}
      autoComplete="off"
      spellCheck={false}
      value={value}
      error={passwordFault(value)}
      onChange={(event) => onChange(event.currentTarget.value)}
      rightSectionWidth={76}
      rightSection={
        <Button variant="subtle" size="compact-xs" onClick={() => onChange(newPassword())}>
          Generate
        </Button>
      }
    />
  );
}
