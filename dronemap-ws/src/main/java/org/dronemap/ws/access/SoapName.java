package org.dronemap.ws.access;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The name of an operation in SOAP, where it is not that of its {@code operationId}: names that the papers of the Dronemap
 * Planner gave, which programs know.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface SoapName {
    String value() default "";

    /** Where a body has alternatives, each is an operation named as the alternative; {@code alternative=name} for other names. */
    String[] alternatives() default {};
}
