import { Pagination } from "@mantine/core";
import { counted } from "../parts/words";
import classes from "./pages.module.css";
import type { Filter } from "./useFilter";

interface PagesProperties {
  filter: Filter;
  total: number;
  pageSize: number;
  noun: string;
}

/** The foot of a list: how many there are, and the way to the other pages. */
export function Pages({ filter, total, pageSize, noun }: PagesProperties) {
  const pages = Math.max(1, Math.ceil(total / pageSize));
  return (
    <div className={classes.foot}>
      <span>{counted(total, noun)}</span>
      {pages > 1 && (
        <Pagination
          size="xs"
          total={pages}
          value={Math.min(filter.page, pages)}
          onChange={(page) => filter.set({ page: page === 1 ? null : String(page) })}
          getControlProps={(control) => ({ "aria-label": `${control} page` })}
        />
      )}
    </div>
  );
}
