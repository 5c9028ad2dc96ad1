import { Button, Menu, useComputedColorScheme, useMantineColorScheme } from "@mantine/core";
import { IconBook, IconChevronDown, IconLogout, IconMoon, IconSun, IconUser } from "@tabler/icons-react";
import { useLocation } from "wouter";
import { signOut } from "../../api/session";
import { useSession } from "../useSession";
import { tellProblem } from "./tell";

/** `compact`: an icon instead of the name, where room is short. */
export function AccountMenu({ compact = false }: { compact?: boolean }) {
  const { account } = useSession();
  const [, go] = useLocation();
  const { setColorScheme } = useMantineColorScheme({ keepTransitions: true });
  const scheme = useComputedColorScheme("dark");
  const leave = () => {
    signOut().then(() => go("/"), tellProblem);
  };
  return (
    <Menu position="bottom-end">
      <Menu.Target>
        {compact ? (
          <Button variant="default" px={8} aria-label={`Account ${account.name}`} title={account.name}>
            <IconUser size={16} aria-hidden />
          </Button>
        ) : (
          <Button variant="default" rightSection={<IconChevronDown size={14} aria-hidden />}>
            {account.name}
          </Button>
        )}
      </Menu.Target>
      <Menu.Dropdown>
        <Menu.Item leftSection={<IconUser size={15} />} onClick={() => go("/account")}>
          Your account
        </Menu.Item>
        <Menu.Item
          leftSection={<IconBook size={15} />}
          component="a"
          href="/docs"
          target="_blank"
          rel="noreferrer"
        >
          API documentation
        </Menu.Item>
        <Menu.Item
          leftSection={scheme === "dark" ? <IconSun size={15} /> : <IconMoon size={15} />}
          onClick={() => setColorScheme(scheme === "dark" ? "light" : "dark")}
        >
          {scheme === "dark" ? "Light theme" : "Dark theme"}
        </Menu.Item>
        <Menu.Divider />
        <Menu.Item leftSection={<IconLogout size={15} />} onClick={leave}>
          Sign out
        </Menu.Item>
      </Menu.Dropdown>
    </Menu>
  );
}
