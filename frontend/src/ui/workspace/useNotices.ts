import { useEffect } from "react";
import { tell } from "../shell/tell";
import { useEditor } from "./context";

/** Says in passing what the editor has to tell, e.g. why an edit was refused. */
export function useNotices(): void {
  const notice = useEditor((state) => state.notice);
  useEffect(() => {
    if (notice !== null) tell(notice.text);
  }, [notice]);
}
