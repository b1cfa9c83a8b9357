/** Names under which what is stored stays readable, whatever the code calls it. */
@NullMarked
package org.dronemap.core.stored;

import org.jspecify.annotations.NullMarked;
