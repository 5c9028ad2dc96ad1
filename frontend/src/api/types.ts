/** The wire's types by their own names; everything else in the app imports them from here. */
import type { components } from "./schema.gen";

type Schemas = components["schemas"];

export type Account = Schemas["AccountOut"];
export type CanonicalForm = Schemas["CanonicalOut"];
export type Change = Schemas["ChangeOut"];
export type CityFrame = Schemas["CityFrame"];
export type CrossingAttributes = Schemas["CrossingAttributes"];
export type Declaration = Schemas["DeclarationOut"];
export type Draft = Schemas["DraftOut"];
export type DraftKept = Schemas["DraftKept"];
export type Drive = Schemas["Drive"];
export type Edit = Schemas["EditIn"];
export type ElementKey = Schemas["ElementKeyOut"];
export type ElementKind = Schemas["ElementKind"];
export type Findings = Schemas["Findings"];
export type Fix = Schemas["FixOut"];
export type IdBlock = Schemas["IdBlockOut"];
export type LaneAttributes = Schemas["LaneAttributes"];
export type LaneType = Schemas["LaneType"];
export type Lidar = Schemas["LidarOut"];
export type Log = Schemas["LogOut"];
export type LogPage = Schemas["LogPage"];
export type MapState = Schemas["MapOut"];
export type Macros = Schemas["MacrosOut"];
export type Mark = Schemas["Mark"];
export type Person = Schemas["PersonOut"];
export type Remark = Schemas["RemarkOut"];
export type RenamedElement = Schemas["RenamedElement"];
export type Revision = Schemas["RevisionOut"];
export type SavedRevision = Schemas["SavedRevision"];
export type Session = Schemas["SessionOut"];
export type Step = Schemas["Step"];
export type StructuralUpdate = Schemas["UpdateOut"];
export type Task = Schemas["TaskOut"];
export type TaskEvent = Schemas["TaskEventOut"];
export type TaskPage = Schemas["TaskPage"];
export type Token = Schemas["TokenOut"];
export type TokenCreated = Schemas["TokenCreated"];
export type Violation = Schemas["ViolationOut"];
export type Workspace = Schemas["Workspace"];
export type Action = Schemas["Action"];
export type Category = Schemas["Category"];
export type Direction = Schemas["Direction"];
export type Role = Schemas["Role"];
export type TaskState = Schemas["TaskState"];

/** An element of a stale save, as the facts of a `save.stale` problem hold it. */
export type ConflictingElement = ElementKey & {
  base: Attributes | null;
  mine: Attributes | null;
  theirs: Attributes | null;
};

/** AV2 attributes of a lane or crossing, by key. */
export type Attributes = Record<string, unknown>;
