@NullMarked
package org.dronemap.cognitive.follow;

import org.jspecify.annotations.NullMarked;
