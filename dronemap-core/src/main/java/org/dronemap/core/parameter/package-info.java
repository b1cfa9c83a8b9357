/**
 * A vehicle's own settings: what it holds, what shall be changed, and the files that ground stations keep them in.
 *
 * <p>Enters: a word about parameters.
 *
 * <p>Never: what one of an autopilot means.
 */
@NullMarked
package org.dronemap.core.parameter;

import org.jspecify.annotations.NullMarked;
