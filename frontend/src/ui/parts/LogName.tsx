import { shortLogName } from "./words";

/** A log's id, short, with the whole id as its title. */
export function LogName({ logId }: { logId: string }) {
  return (
    <span className="mono" title={logId}>
      {shortLogName(logId)}
    </span>
  );
}
