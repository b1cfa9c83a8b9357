<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Closure;
use Dronemap\SoapProxy\Problem;
use PHPUnit\Framework\Assert;

/** What was refused, and how. */
final class Problems
{
    public static function of(Closure $refused): Problem
    {
        try {
            $refused();
        } catch (Problem $problem) {
            return $problem;
        }
        Assert::fail('It was not refused.');
    }
}
