import { createTheme, Modal, Tooltip } from "@mantine/core";

/** Colours live in tokens.css; here is only what Mantine must know as values. */
export const theme = createTheme({
  primaryColor: "blue",
  defaultRadius: 6,
  cursorType: "pointer",
  components: {
    // Locking the page's scroll injects a <style>, which the Content-Security-Policy refuses; no page scrolls anyway.
    Modal: Modal.extend({
      defaultProps: { lockScroll: false, centered: true, closeButtonProps: { "aria-label": "Close" } },
    }),
    Drawer: { defaultProps: { lockScroll: false } },
    Tooltip: Tooltip.extend({ defaultProps: { openDelay: 400, withArrow: false } }),
    Button: { defaultProps: { size: "xs" } },
    TextInput: { defaultProps: { size: "xs" } },
    PasswordInput: {
      defaultProps: { size: "xs", visibilityToggleButtonProps: { "aria-label": "Show what is typed" } },
    },
    Select: { defaultProps: { size: "xs", checkIconPosition: "right" } },
    Textarea: { defaultProps: { size: "xs" } },
    Checkbox: { defaultProps: { size: "xs" } },
    NumberInput: { defaultProps: { size: "xs" } },
    Menu: { defaultProps: { shadow: "none" } },
  },
});
