@NullMarked
package org.dronemap.cognitive.engine;

import org.jspecify.annotations.NullMarked;
