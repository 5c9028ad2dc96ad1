import { Link } from "wouter";

export function NoSuchRule({ code }: { code: string | null }) {
  return (
    <p className="second">
      There is no rule <code>{code}</code>. <Link href="/rules">All rules</Link>
    </p>
  );
}
