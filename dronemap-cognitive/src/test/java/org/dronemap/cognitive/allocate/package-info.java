@NullMarked
package org.dronemap.cognitive.allocate;

import org.jspecify.annotations.NullMarked;
