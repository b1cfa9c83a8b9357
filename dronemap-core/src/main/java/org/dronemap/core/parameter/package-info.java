/** A vehicle's own settings: what it holds, what shall be changed, and the files that ground stations keep them in. */
@NullMarked
package org.dronemap.core.parameter;

import org.jspecify.annotations.NullMarked;
