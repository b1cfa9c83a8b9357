package org.dronemap.ws.reading;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** The values that a text, or each of a list of texts, may have: those of an enum, as {@link WireNames#camel} calls them. */
@Target(ElementType.RECORD_COMPONENT)
@Retention(RetentionPolicy.RUNTIME)
public @interface EnumValues {
    Class<? extends Enum<?>> value();

    /** Further values. */
    String[] and() default {};
}
