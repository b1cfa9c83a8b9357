/**
 * Access keys of programs: what each may do, where, and until when.
 *
 * <p>Enters: use cases about keys that users issue for programs.
 *
 * <p>Never: keys of vehicles and robots.
 */
@NullMarked
package org.dronemap.ws.key;

import org.jspecify.annotations.NullMarked;
