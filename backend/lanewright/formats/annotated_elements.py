"""Which elements an annotation means: the updates of spec §8 name them by id, and ids are unique in a kind only."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from functools import cached_property

from lanewright.core.diff import diff
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.errors import InvalidInput, Place


class AnnotatedElements:
    """The elements of two maps, each to be named once."""

    def __init__(self, base: MapState, edited: MapState):
        self._base, self._edited = base, edited
        self._places: dict[ElementKey, str] = {}

    def named(self, element: ElementKey, key: str) -> ElementKey:
        """That element, named at ``key``. Raises InvalidInput if it is in neither map, or was named before."""
        place = Place(element=f"{element.kind.value} {element.id}", key=key)
        if not self._exists(element):
            raise InvalidInput("is in neither map", "Check the id, and that these are the maps annotated.", place)
        before = self._places.setdefault(element, key)
        if before != key:
            raise InvalidInput(f"stands in {before} already", "Name each element once.", place)
        return element

    def of_update(self, names: Mapping[str, ElementKey | int]) -> tuple[ElementKey, ...]:
        """The elements of one update, sorted; ``names`` holds, by the key where it stands, an element or its id.

        An id that both a lane and a crossing have means both where it stands twice. Where it stands once, the update
        with these ids that follows from the maps says which is meant; of several, the next in the order of the diff.

        Raises:
            InvalidInput: an element is in neither map or was named before, or its id could mean two.
        """
        ids = {key: name for key, name in names.items() if isinstance(name, int)}
        times = Counter(ids.values())
        meant = {key: self._with_id(number, key) for key, number in ids.items()}
        unclear = [key for key, elements in meant.items() if len(elements) > times[ids[key]]]
        if unclear:
            derived = self._derived(ids.values()) if len(ids) == len(names) else ()
            if not derived:
                raise _could_mean_two(meant[unclear[0]], unclear[0])
            places = {number: key for key, number in ids.items()}
            return tuple(self.named(element, places[element.id]) for element in derived)
        found = [self.named(name, key) for key, name in names.items() if isinstance(name, ElementKey)]
        for key, elements in meant.items():
            free = [element for element in elements if element not in self._places]
            found.append(self.named((free or elements)[0], key))
        return tuple(sorted(found))

    def _exists(self, element: ElementKey) -> bool:
        return element in self._base or element in self._edited

    def _with_id(self, number: int, key: str) -> list[ElementKey]:
        elements = [element for kind in ElementKind if self._exists(element := ElementKey(kind, number))]
        if not elements:
            mend = "Check the id, and that these are the maps annotated."
            raise InvalidInput(f"is {number}, an element of neither map", mend, Place(key=key))
        return elements

    def _derived(self, ids: Iterable[int]) -> tuple[ElementKey, ...]:
        """The first update with these ids of which no element was named yet; none: empty."""
        updates = self._updates.get(tuple(sorted(ids)), [])
        return next((elements for elements in updates if self._places.keys().isdisjoint(elements)), ())

    @cached_property
    def _updates(self) -> Mapping[tuple[int, ...], list[tuple[ElementKey, ...]]]:
        """The derived updates by their ids, those of the same ids in the order of the diff."""
        updates: dict[tuple[int, ...], list[tuple[ElementKey, ...]]] = {}
        for elements in sorted(update.elements for update in diff(self._base, self._edited).updates):
            updates.setdefault(tuple(sorted(element.id for element in elements)), []).append(elements)
        return updates


def _could_mean_two(elements: list[ElementKey], key: str) -> InvalidInput:
    kinds = " and ".join(f"a {element.kind.value}" for element in elements)
    example = f'{{"kind": "{elements[0].kind.value}", "id": {elements[0].id}}}'
    return InvalidInput(f"is {elements[0].id}, which {kinds} have", f"Name the kind: {example}.", Place(key=key))
