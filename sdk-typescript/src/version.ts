/** The version of the server that this client was made with; the package has the same. */
export const VERSION = '0.1.0';
