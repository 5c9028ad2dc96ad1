"""``make bench``: every figure beside what it is measured against."""

from __future__ import annotations

from bench import engine, store


def main() -> None:
    for title, module in (("Engine", engine), ("Store", store)):
        print(title)
        for figure in module.figures():
            print(f"  {figure}")


if __name__ == "__main__":
    main()
