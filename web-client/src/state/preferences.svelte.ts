export type Theme = 'light' | 'dark';
export type ThemeChoice = Theme | 'system';

const THEME_KEY = 'dronemap.theme';
const NEXT: Record<ThemeChoice, ThemeChoice> = { system: 'light', light: 'dark', dark: 'system' };

/** The preferences of the user, stored in this browser. */
export class Preferences {
  choice = $state<ThemeChoice>('system');
  #systemDark = $state(false);

  constructor() {
    const stored = read(THEME_KEY);
    if (stored === 'light' || stored === 'dark') {
      this.choice = stored;
    }
    const query = matchMedia('(prefers-color-scheme: dark)');
    this.#systemDark = query.matches;
    query.addEventListener('change', (event) => (this.#systemDark = event.matches));
  }

  get theme(): Theme {
    if (this.choice !== 'system') {
      return this.choice;
    }
    return this.#systemDark ? 'dark' : 'light';
  }

  nextTheme(): void {
    this.choice = NEXT[this.choice];
    write(THEME_KEY, this.choice);
  }
}

function read(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    // Storage may be forbidden; the choice then lasts as long as the page.
    return null;
  }
}

function write(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    console.info('This browser keeps no settings for this page.');
  }
}
