import type { Change } from "../../../api/types";
import type { MapElement } from "../../../editor";
import { CategoryMark } from "../../parts/CategoryMark";
import { useFindings } from "../useFindings";
import { attributeRows } from "./attributeRows";
import classes from "./inspector.module.css";

/** What changed on the element since the import, old → new. */
export function ElementChange({ element }: { element: MapElement }) {
  const { findings } = useFindings();
  const change = findings?.changes.find(({ kind, id }) => kind === element.kind && id === element.id);
  if (change === undefined) return null;
  return (
    <section className={classes.section}>
      <h3 className="label">Change</h3>
      <p className={classes.headline}>
        <CategoryMark categories={change.categories} />
        {change.headline}
      </p>
      {change.detail !== "" && <p className="second">{change.detail}</p>}
      {change.exported_as !== "" && <p className="third small">{change.exported_as}</p>}
      <Rows change={change} />
    </section>
  );
}

function Rows({ change }: { change: Change }) {
  return (
    <dl className={classes.rows}>
      {attributeRows(change).map(({ name, before, after }) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>
            <del>{before}</del> → <ins>{after}</ins>
          </dd>
        </div>
      ))}
    </dl>
  );
}
