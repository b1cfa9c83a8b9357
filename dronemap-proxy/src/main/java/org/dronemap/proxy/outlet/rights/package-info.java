/**
 * Rights of those who attach to the outlet: what they come in by, and what their user may do now.
 *
 * <p>Enters: a way to be let in, and a limit of what it allows.
 *
 * <p>Never: what an attached program is shown or asks for.
 */
@NullMarked
package org.dronemap.proxy.outlet.rights;

import org.jspecify.annotations.NullMarked;
