//! What of the pages runs: their snippets as documentation tests, and live scenes and numbers in browsers.

live::pages!(pages::scenes::SCENES);
