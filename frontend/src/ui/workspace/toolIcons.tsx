/** Icons of the drawing tools, in the stroke of the icon set that the other buttons use. */
import type { ReactNode } from "react";

function Icon({ size, children }: { size: number; children: ReactNode }) {
  return (
    <svg
      width={size}
      height={size}
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      strokeWidth={2}
      strokeLinecap="round"
      strokeLinejoin="round"
      aria-hidden="true"
    >
      {children}
    </svg>
  );
}

export function LaneIcon({ size }: { size: number }) {
  return (
    <Icon size={size}>
      <path d="M6 20 9 4M18 20 15 4M12 19v-3m0-3.5v-2m0-3.5V5.500" />
    </Icon>
  );
}

export function LaneBesideIcon({ size }: { size: number }) {
  return (
    <Icon size={size}>
      <path d="M4 20V4m6 16V4" />
      <path d="M16 20v-3m0-4v-2m0-4V4" />
      <path d="M19 12h4m-2-2v4" />
    </Icon>
  );
}

export function CutIcon({ size }: { size: number }) {
  return (
    <Icon size={size}>
      <path d="M7 21v-6m0-6V3m10 18v-6m0-6V3" />
      <path d="M3 12h18" strokeDasharray="3 3" />
    </Icon>
  );
}

export function CrossingIcon({ size }: { size: number }) {
  return (
    <Icon size={size}>
      <path d="M4 7v10m5.300-10v10m5.400-10v10M20 7v10" strokeWidth={2.6} />
    </Icon>
  );
}
