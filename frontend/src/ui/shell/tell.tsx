import { notifications } from "@mantine/notifications";
import { asProblem } from "../../api/problem";

const CLOSING = { closeButtonProps: { "aria-label": "Dismiss" } };

/** Says in passing what went wrong, with the mend and the request id. */
export function tellProblem(error: unknown): void {
  const problem = asProblem(error);
  notifications.show({
    id: problem.code,
    color: "red",
    title: problem.message,
    message: [problem.mend, problem.requestId && `request ${problem.requestId}`].filter(Boolean).join(" · "),
    autoClose: 12_000,
    ...CLOSING,
  });
}

/** Says in passing that something is done. */
export function tell(message: string): void {
  notifications.show({ message, autoClose: 4_000, ...CLOSING });
}
