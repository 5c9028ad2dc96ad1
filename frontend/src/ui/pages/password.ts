/** Shortest password that the server takes. */
export const MIN_PASSWORD_LENGTH = 10;

const ALPHABET = "abcdefghijkmnpqrstuvwxyzABCDEFGHJKLMNPQRSTUVWXYZ23456789";

/** A random password of 16 characters that cannot be misread (no 0/O, 1/l). */
export function newPassword(): string {
  let password = "";
  while (password.length < 16) {
    const [byte = 255] = crypto.getRandomValues(new Uint8Array(1));
    if (byte < Math.floor(256 / ALPHABET.length) * ALPHABET.length) {
      password += ALPHABET[byte % ALPHABET.length] ?? "";
    }
  }
  return password;
}

/** What is wrong with a new password, in words; null: nothing. */
export function passwordFault(password: string): string | null {
  if (password === "" || password.length >= MIN_PASSWORD_LENGTH) return null;
  return `At least ${MIN_PASSWORD_LENGTH} characters; ${MIN_PASSWORD_LENGTH - password.length} more.`;
}
