@NullMarked
package org.dronemap.core.stored;

import org.jspecify.annotations.NullMarked;
